#pragma once

#include "shared/fields.hpp"
#include "shared/math/vec3.hpp"
#include "shared/table/ball.hpp"
#include "shared/table/bounds.hpp"

#include <tuple>

namespace poolhall {

/// The blow of the cue. A direction, never an angle: nothing has to be evaluated by a trigonometric
/// function, here or on another machine.
struct Strike {
    BallIndex ball;
    Vec2 direction{1, 0};  ///< of any length but zero
    Real speed = 0;        ///< of the ball right after it, m/s
    /// Where the tip hits, seen along the cue: [side, vertical] in radii, shorter than 1. Side > 0
    /// is right english, vertical > 0 follow.
    Vec2 offset = {};
    Real elevation = 0;  ///< slope of the cue: how far it falls per metre of horizontal way
    /// Effective end mass of the cue over the ball's mass: what deflects the cue ball (squirt).
    Real end_mass_ratio = 0;

    static constexpr double kMaxSlope = 10;  ///< of the cue

    static constexpr auto field_list() {
        return std::tuple{
            fields::of("ball", &Strike::ball),
            fields::of("direction", &Strike::direction),
            fields::of("speed", &Strike::speed, kSpeeds).in("m/s"),
            fields::of("offset", &Strike::offset).or_default(),
            fields::of("elevation", &Strike::elevation, {0, kMaxSlope}).or_default(),
            fields::of("end_mass_ratio", &Strike::end_mass_ratio, {0, 1}).or_default()};
    }

    friend constexpr bool operator==(const Strike&, const Strike&) = default;
};

struct CueBallMotion {
    Vec3 v;  ///< m/s; z is not positive
    Vec3 w;  ///< rad/s
};

/// The motion of a ball of that radius (m) right after the strike, before the slate acts: a cue
/// that slopes down leaves v.z < 0, which becomes a bounce or nothing.
///
/// The speed is the strike's. The spin is w = (5 / (2 R^2)) offset x v with v along the cue
/// (Alciatore, TP A.12): right english turns the ball counterclockwise seen from above. The end of
/// the cue deflects v from the cue's line, away from the english (squirt, TP A.31).
[[nodiscard]] CueBallMotion strike_motion(const Strike& strike, Real radius);

/// The tangent of the angle of squirt, with the sign of `side` (radii, shorter than 1):
/// (5/2) b sqrt(1 - b^2) / (1 + 1/m + (5/2)(1 - b^2)), where m is the effective end mass of the cue
/// over the ball's mass; m = 0 gives none; pooltool takes 1/30. Alciatore, TP A.31.
[[nodiscard]] Real squirt_tangent(Real side, Real end_mass_ratio);

}  // namespace poolhall
