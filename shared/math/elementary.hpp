#pragma once

namespace poolhall::elementary {

// Elementary functions of our own: those of C libraries differ in the last digit, and a shot must
// not. From + - * / and the bits of doubles only. Each is within 1 ulp of the exact value over the
// whole range (0.6 ulp seen), subnormal results within 1 of their ulps. NaN gives NaN.

/// e^x. 0 below -745.14, infinity above 709.79.
[[nodiscard]] double exp(double x);

/// e^x - 1 without cancellation near 0: the way left by linear drag, for instance.
[[nodiscard]] double expm1(double x);

/// Natural logarithm. -infinity at 0, NaN below.
[[nodiscard]] double log(double x);

/// log(1 + x) without cancellation near 0. -infinity at -1, NaN below.
[[nodiscard]] double log1p(double x);

}  // namespace poolhall::elementary
