#pragma once

#include "shared/math/vec3.hpp"
#include "shared/physics/contact/rail_contact.hpp"

#include <algorithm>

namespace poolhall {

/// What a rail and the cloth give to a ball in an impact, per mass of the ball, m/s.
struct RailImpulse {
    Real normal = 0;  ///< of the nose, from it to the ball's centre
    Vec2 nose;        ///< taken away by friction at the nose: x along the rail, y up its face
    Vec2 cloth;       ///< taken away by friction at the cloth: x along the rail, y into it
};

/// A ball at a rail in the rail's frame: x along it, y into it, z up, right-handed. The nose
/// touches the ball at R (0, cos theta, sin theta) from its centre (Han 2005, fig. 4; Mathavan,
/// Jackson, Parkin 2010, fig. 1). Everything is a speed in m/s, spins too: they are R w.
///
/// The ball stays on the cloth: the slate takes the vertical impulse, or gravity where it points
/// up, at no loss of energy.
struct BallAtRail {
    Real sin_theta = 0;
    Real cos_theta = 1;
    Vec2 v;
    Vec3 spin;

    BallAtRail(const RailContact& rail, const Vec3& velocity, const Vec3& w)
        : sin_theta(std::clamp(rail.nose_height / rail.radius - 1, Real{-1}, Real{1})),
          cos_theta(sqrt((1 - sin_theta) * (1 + sin_theta))),
          v{along(rail, xy(velocity)), dot(rail.normal, xy(velocity))},
          spin{rail.radius * along(rail, xy(w)), rail.radius * dot(rail.normal, xy(w)),
               rail.radius * w.z} {}

    /// Velocity of the ball's surface at the nose: x along the rail, y up its face.
    [[nodiscard]] Vec2 nose_slip() const {
        return {v.x + sin_theta * spin.y - cos_theta * spin.z, spin.x - sin_theta * v.y};
    }

    /// Velocity of the ball's surface at the cloth: x along the rail, y into it.
    [[nodiscard]] Vec2 cloth_slip() const { return {v.x - spin.y, v.y + spin.x}; }

    /// What the impulse does to v; a solid sphere.
    [[nodiscard]] Vec2 change_of_v(const RailImpulse& j) const {
        return {-(j.nose.x + j.cloth.x),
                -(cos_theta * j.normal - sin_theta * j.nose.y + j.cloth.y)};
    }

    /// What the impulse does to R w.
    [[nodiscard]] Vec3 change_of_spin(const RailImpulse& j) const {
        return {-2.5 * (j.nose.y + j.cloth.y), -2.5 * (sin_theta * j.nose.x - j.cloth.x),
                2.5 * cos_theta * j.nose.x};
    }

    /// The component along the rail of a vector in the plane.
    static Real along(const RailContact& rail, Vec2 a) { return cross(a, rail.normal); }

    /// The vector in the plane that has these components along and into the rail.
    static Vec2 in_plane(const RailContact& rail, Real along, Real into) {
        return {along * rail.normal.y + into * rail.normal.x,
                into * rail.normal.y - along * rail.normal.x};
    }
};

/// Gives the impulse to the ball. A ball that would go on into the rail is stopped at it: the rail
/// lets nothing through, even where its model is out of its depth (a high nose with a small e).
inline void apply(const RailImpulse& j, const BallAtRail& ball, const RailContact& rail, Vec3& v,
                  Vec3& w) {
    const Vec2 dv = ball.change_of_v(j);
    const Vec3 dw = (1 / rail.radius) * ball.change_of_spin(j);
    set_xy(v, xy(v) + BallAtRail::in_plane(rail, dv.x, std::min(dv.y, -ball.v.y)));
    w = w + Vec3{0, 0, dw.z};
    set_xy(w, xy(w) + BallAtRail::in_plane(rail, dw.x, dw.y));
}

}  // namespace poolhall
