#pragma once

#include <cmath>

namespace poolhall::testing {

/// 113-bit floating point, to check doubles against.
#if defined(__SIZEOF_FLOAT128__)
__extension__ typedef __float128 Quad;  // NOLINT(modernize-use-using): __extension__ takes no using
#else
using Quad = long double;
#endif

inline double to_double(Quad x) {
    return static_cast<double>(x);
}

inline Quad abs(Quad x) {
    return x < 0 ? -x : x;
}

/// Newton's steps from the double's root; x in a double's range.
inline Quad sqrt(Quad x) {
    if (x <= 0) return 0;
    Quad root = std::sqrt(to_double(x));
    for (int i = 0; i < 2; ++i)
        root = (root + x / root) / 2;
    return root;
}

/// |actual - expected| / |expected|.
inline double relative_error(double actual, Quad expected) {
    return to_double(abs((actual - expected) / expected));
}

}  // namespace poolhall::testing
