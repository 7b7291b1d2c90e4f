#pragma once

#include <cmath>
#include <limits>

// The numbers that take part in the physics. They are doubles; client/lab/reference compiles the
// same sources once more with a header of its own, which defines what stands here in the #else.
#ifdef POOLHALL_REAL_HEADER
#include POOLHALL_REAL_HEADER
#else
namespace poolhall {

using Real = double;
inline constexpr int kRealDigits = 53;  ///< bits of a significand

// Called as abs(x) and sqrt(x), never as std::abs(x): the standard library has them for its own
// types only, and a type that is built into the compiler is not found by its arguments.
using std::abs;
using std::sqrt;

}  // namespace poolhall
#endif

namespace poolhall {

/// 2^exponent, of a size that a double can have.
constexpr Real power_of_two(int exponent) {
    Real power = 1;
    for (int i = 0; i < exponent; ++i)
        power *= 2;
    for (int i = 0; i > exponent; --i)
        power /= 2;
    return power;
}

inline constexpr Real kInfinity = std::numeric_limits<double>::infinity();
/// From 1 to the next number; 2^-52 of doubles. Tolerances that stand for rounding are multiples of
/// it.
inline constexpr Real kEpsilon = power_of_two(1 - kRealDigits);
/// Its square root; 2^-26 of doubles.
inline constexpr Real kRootEpsilon = power_of_two((1 - kRealDigits) / 2);
static_assert(kRootEpsilon * kRootEpsilon == kEpsilon);
/// How much finer than doubles these numbers are: brings to them what was found with doubles.
inline constexpr Real kFineness = kEpsilon / 0x1p-52;

}  // namespace poolhall
