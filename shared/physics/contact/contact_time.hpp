#pragma once

#include "shared/math/vec3.hpp"
#include "shared/physics/motion/arc.hpp"

namespace poolhall {

/// One centre as seen from another while both move with constant acceleration: c + v t + a t^2 / 2.
/// Vec is Vec2 on the cloth and Vec3 in the air.
template <class Vec>
struct RelativeArc {
    Vec c;  ///< m
    Vec v;  ///< m/s
    Vec a;  ///< m/s^2
};

/// The first t in [0, horizon] (s) at which the centres come within `distance` (m) while they
/// approach; kNever if they do not. 0 where they are that near already and approach, or are pressed
/// together.
///
/// The gap |c(t)|^2 - d^2 is a quartic, whose leading terms vanish when the accelerations are
/// equal: the ordinary case. So it is never solved by formula. Its extremes are bracketed by the
/// roots of its derivatives, of falling degree, and the first stretch on which it falls through
/// zero is polished by a safeguarded Newton iteration. Where rounding could decide (a graze), the
/// gap is taken in double-double. Straight relative motion (v parallel to a) is reduced to
/// time_of_impact().
[[nodiscard]] Real first_contact(const RelativeArc<Vec2>& arc, Real distance, Real horizon);
[[nodiscard]] Real first_contact(const RelativeArc<Vec3>& arc, Real distance, Real horizon);

/// True only if first_contact() of (c, v, a) is kNever, by bounds that cost no root and hardly a
/// division: most pairs that never meet are found so. The horizon is finite.
[[nodiscard]] bool stay_apart(Vec2 c, Vec2 v, Vec2 a, Real distance, Real horizon);

/// As first_contact(), for a centre that moves along v and loses `deceleration` (m/s^2) until it
/// stops.
[[nodiscard]] Real first_contact_straight(Vec2 c, Vec2 v, Real deceleration, Real distance,
                                          Real horizon);

/// As first_contact() without acceleration and without end, in space.
[[nodiscard]] Real straight_contact(const Vec3& c, const Vec3& v, Real distance);

/// The first t >= 0 (s) at which v t + a t^2 / 2 reaches `gap` (m) from below; kNever if it does
/// not. 0 where the gap is closed and still closing.
[[nodiscard]] Real time_to_close(Real gap, Real v, Real a);

}  // namespace poolhall
