#pragma once

// Stands for the #else of shared/math/real.hpp in the sources that are compiled a second time.
namespace poolhall {

/// IEEE 754 binary128: 113 bits. + - * / are the compiler's, correctly rounded.
#if __LDBL_MANT_DIG__ == 113
using Real = long double;
#else
__extension__ typedef __float128 Real;  // NOLINT(modernize-use-using): __extension__ takes no using
#endif
inline constexpr int kRealDigits = 113;

/// Correctly rounded, as with doubles. glibc's, by its symbol: its header declares it for a type
/// that each compiler calls by another name.
Real sqrt(Real x) __asm__("sqrtf128");

constexpr Real abs(Real x) {
    return x < 0 ? -x : x;
}

}  // namespace poolhall
