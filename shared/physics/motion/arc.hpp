#pragma once

#include "shared/math/elementary.hpp"
#include "shared/physics/motion/moving_ball.hpp"

#include <algorithm>

namespace poolhall {

inline constexpr Real kNever = kInfinity;

/// How a ball goes on by itself from the state that it has at `since`: its centre on a parabola
/// (or, under linear drag, straight on), its spin linear in time. A place is evaluated once from
/// that state and never accumulated.
struct Arc {
    Real since = 0;       ///< s
    Real until = kNever;  ///< when the motion changes by itself, s
    Vec2 a;               ///< m/s^2
    Vec2 dw;              ///< of the spin about the horizontal axes, rad/s^2
    Real side_decay = 0;  ///< rad/s^2, at least 0: |wz| falls at this rate down to 0
    Real gravity = 0;     ///< m/s^2, at least 0: of a ball in the air
    Real drag = 0;        ///< 1/s, at least 0: v' = -drag v, with a = 0
};

/// The way that a velocity of 1 m/s leads in t s under linear drag: (1 - exp(-k t)) / k; m.
[[nodiscard]] inline Real way_under_drag(Real k, Real t) {
    return k > 0 ? -elementary::expm1(-k * t) / k : t;
}

/// The inverse of way_under_drag(): -log(1 - k s) / k; kNever for a way that is never done.
[[nodiscard]] inline Real time_under_drag(Real k, Real s) {
    if (k == 0) return s;
    return k * s < 1 ? -elementary::log1p(-k * s) / k : kNever;
}

[[nodiscard]] inline Vec2 place_on(const MovingBall& ball, const Arc& arc, Real t) {
    const Real dt = t - arc.since;
    if (arc.drag > 0) [[unlikely]]
        return ball.r + way_under_drag(arc.drag, dt) * ball.v;
    return ball.r + dt * (ball.v + (dt / 2) * arc.a);
}

[[nodiscard]] inline Vec2 velocity_on(const MovingBall& ball, const Arc& arc, Real t) {
    const Real dt = t - arc.since;
    if (arc.drag > 0) return elementary::exp(-arc.drag * dt) * ball.v;
    return ball.v + dt * arc.a;
}

[[nodiscard]] inline Real height_on(const MovingBall& ball, const Arc& arc, Real t) {
    const Real dt = t - arc.since;
    return ball.height + dt * (ball.climb - (dt / 2) * arc.gravity);
}

/// Brings the ball to t on its arc.
inline void advance(MovingBall& ball, const Arc& arc, Real t) {
    const Real dt = t - arc.since;
    const Vec2 r = place_on(ball, arc, t);
    if (ball.motion == Motion::kAirborne) {
        ball.height = height_on(ball, arc, t);
        ball.climb -= dt * arc.gravity;
    }
    ball.v = velocity_on(ball, arc, t);
    ball.r = r;
    ball.w.x += dt * arc.dw.x;
    ball.w.y += dt * arc.dw.y;
    const Real lost = dt * arc.side_decay;
    if (lost > 0) {
        const Real left = std::max(abs(ball.w.z) - lost, Real{0});
        ball.w.z = ball.w.z < 0 ? -left : left;
    }
}

/// The ball at t on its arc.
[[nodiscard]] inline MovingBall ball_on(MovingBall ball, const Arc& arc, Real t) {
    advance(ball, arc, t);
    return ball;
}

}  // namespace poolhall
