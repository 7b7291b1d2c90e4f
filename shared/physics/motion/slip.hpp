#pragma once

#include "shared/physics/motion/moving_ball.hpp"

// A ball that touches the cloth: how it slips there, and what a force at that point does to it.
namespace poolhall {

/// Slip of the point that touches the cloth, m/s.
[[nodiscard]] inline Vec2 slip_of(const MovingBall& ball) {
    return {ball.v.x - ball.radius * ball.w.y, ball.v.y + ball.radius * ball.w.x};
}

/// Whether a ball in that state slips on the cloth, by more than rounding.
[[nodiscard]] inline bool slips(const BallState& state, Real radius) {
    constexpr Real kRounding = 1e-9;
    const Vec2 turns{radius * state.w.y, -radius * state.w.x};
    const Vec2 slip = xy(state.v) - turns;
    return state.r.z == 0 && norm(slip) > kRounding * (norm(xy(state.v)) + norm(turns));
}

/// The spin about the horizontal axes with which a ball rolls, rad/s.
[[nodiscard]] inline Vec2 rolling_spin(Vec2 v, Real radius) {
    return {-v.y / radius, v.x / radius};
}

/// The velocity at which the slip has gone, whatever the friction: v - 2/7 u.
[[nodiscard]] inline Vec2 velocity_after_slip(Vec2 v, Vec2 slip) {
    return v - (Real{2} / 7) * slip;
}

/// Takes an impulse of the cloth, per mass of the ball (m/s), from its velocity; the spin changes
/// with it.
inline void rub(MovingBall& ball, Vec2 impulse) {
    ball.v = ball.v - impulse;
    const Real turn = 5 / (2 * ball.radius);
    ball.w.x = ball.w.x - turn * impulse.y;
    ball.w.y = ball.w.y + turn * impulse.x;
}

}  // namespace poolhall
