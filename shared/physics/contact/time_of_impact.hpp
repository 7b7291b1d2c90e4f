#pragma once

#include "shared/math/vec2.hpp"

#include <optional>

namespace poolhall {

/// A centre that moves uniformly: r + v t.
struct UniformMotion {
    Vec2 r;  ///< m
    Vec2 v;  ///< m/s
};

/// When the centres a and b, which approach each other, come within `distance` (m): the smallest t
/// >= 0, in s. 0 where they are that near already and approach. Nothing where they do not approach
/// or pass each other by; an exact graze is a hit.
///
/// With c = b.r - a.r, v = b.v - a.v, A = v.v, B = -c.v, C = c.c - d^2: t = C / (B + sqrt q), q = A
/// d^2 - (c x v)^2. The textbook's q = B^2 - A C is the same number, but cancels near grazing
/// (HARD_CASES: wrong verdicts at 1e-7 rad). Where rounding could still matter the four terms are
/// taken in double-double from the unrounded differences. Relative error of t below 1e-14; verdicts
/// right to the last bit. Places and `distance` up to 1e30 m, any finite velocity.
[[nodiscard]] std::optional<Real> time_of_impact(const UniformMotion& a, const UniformMotion& b,
                                                 Real distance);

/// How long ago (s) two overlapping centres that have moved uniformly were `distance` (m) apart:
/// the larger root of A t^2 + 2 B t + C = 0 with the terms above, (sqrt q - B) / A or, where B > 0,
/// -C / (B + sqrt q). It is the correction of the text's 5.2.1, whose form cancels for a ball that
/// has just come in. Their relative velocity must not be zero.
[[nodiscard]] Real time_since_impact(const UniformMotion& a, const UniformMotion& b, Real distance);

}  // namespace poolhall
