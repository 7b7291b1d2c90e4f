#pragma once

#include "shared/math/vec3.hpp"
#include "shared/table/ball.hpp"

#include <cstddef>
#include <limits>

namespace poolhall {

/// A ball while it is simulated.
struct MovingBall {
    static constexpr std::size_t kNobody = std::numeric_limits<std::size_t>::max();

    Vec2 r;           ///< m
    Vec2 v;           ///< m/s
    Vec3 w;           ///< rad/s
    Real height = 0;  ///< of the centre above its height at rest, m
    Real climb = 0;   ///< vertical velocity, m/s
    Real radius = 0;  ///< m
    Real reach = 0;   ///< to the nose of a rail that it touches, from above, m (rail_reach())
    Real mass = 0;    ///< kg
    Motion motion = Motion::kStationary;
    /// The ball met last, until anything else happens to either. Two bodies that move uniformly
    /// after their impact do not meet again, but rounding could say so near grazing.
    std::size_t partner = kNobody;
};

[[nodiscard]] constexpr BallState state_of(const MovingBall& ball) {
    return {{ball.r.x, ball.r.y, ball.height}, {ball.v.x, ball.v.y, ball.climb}, ball.w};
}

[[nodiscard]] constexpr bool in_play(const MovingBall& ball) {
    return ball.motion != Motion::kPocketed && ball.motion != Motion::kOffTable;
}

[[nodiscard]] constexpr bool is_on_cloth(Motion motion) {
    return motion == Motion::kSliding || motion == Motion::kRolling ||
           motion == Motion::kSpinning || motion == Motion::kStationary;
}

[[nodiscard]] constexpr bool moves_centre(Motion motion) {
    return motion == Motion::kSliding || motion == Motion::kRolling || motion == Motion::kAirborne;
}

/// Two bodies that touch: what their distance and their approach are off by within this share is
/// rounding.
inline constexpr Real kTouchRounding = 16 * kEpsilon;
/// Balls that overlap by no more than this are taken as touching, m.
inline constexpr Real kTouchTolerance = 1e-9;

/// How far apart the centres of two balls are, in the plane, when they touch on the cloth (m):
/// 2 sqrt(R_a R_b), since centres of different radius are at different heights.
[[nodiscard]] inline Real contact_distance(Real radius_a, Real radius_b) {
    return radius_a == radius_b ? 2 * radius_a : 2 * sqrt(radius_a * radius_b);
}

[[nodiscard]] inline Real contact_distance(const MovingBall& a, const MovingBall& b) {
    return contact_distance(a.radius, b.radius);
}

/// From the centre of ball a to that of ball b in space, m.
[[nodiscard]] inline Vec3 between_centres(const MovingBall& a, const MovingBall& b) {
    const Vec2 c = b.r - a.r;
    return {c.x, c.y, (b.height - a.height) + (b.radius - a.radius)};
}

}  // namespace poolhall
