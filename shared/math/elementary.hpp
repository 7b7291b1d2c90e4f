#pragma once

#include "shared/math/real.hpp"

namespace poolhall::elementary {

// Elementary functions of our own: those of C libraries differ in the last digit, and a shot must
// not. For doubles, from + - * / and their bits only. Each is within 1 ulp of the exact value over
// the whole range (0.6 ulp seen), subnormal results within 1 of their ulps. NaN gives NaN. Where
// Real is no double, who compiles the sources brings these.

/// e^x. 0 below -745.14, infinity above 709.79.
[[nodiscard]] Real exp(Real x);

/// e^x - 1 without cancellation near 0: the way left by linear drag, for instance.
[[nodiscard]] Real expm1(Real x);

/// Natural logarithm. -infinity at 0, NaN below.
[[nodiscard]] Real log(Real x);

/// log(1 + x) without cancellation near 0. -infinity at -1, NaN below.
[[nodiscard]] Real log1p(Real x);

}  // namespace poolhall::elementary
