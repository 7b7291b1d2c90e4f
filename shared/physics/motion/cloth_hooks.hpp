#pragma once

#include "shared/physics/motion/moving_ball.hpp"

#include <type_traits>

// What an effect may do to a ball between impacts. The cloth (cloth.hpp) asks a set of effects for
// these hooks, never for an effect by name; at most one effect of a set has each, but for forces.
// A hook that no effect of the set has leaves no instruction behind.
namespace poolhall {

/// Friction on a ball that slips. In a step of dt s it takes slip_loss(dt) (m/s) from its velocity;
/// step_slip() does so and is true where the slip ends. In closed form the centre decelerates with
/// slip_deceleration() (m/s^2) for slip_time(slip speed) s while the spin changes at
/// slip_spin_rate(direction of the slip, radius) (rad/s^2).
template <class Effect>
concept SlipEffect = requires(const Effect& effect, MovingBall& ball, Vec2 direction) {
    effect.rubs();  // whether there is any
    effect.slip_loss(Real{});
    effect.step_slip(ball, Real{});
    effect.slip_deceleration();
    effect.slip_time(Real{});
    effect.slip_spin_rate(direction, Real{});
};

/// Resistance to a ball that rolls: likewise, along its velocity.
template <class Effect>
concept RollEffect = requires(const Effect& effect, MovingBall& ball) {
    effect.roll_loss(Real{});
    effect.step_roll(ball, Real{});
    effect.roll_deceleration();
};

/// Friction on the spin about the vertical axis: spin_deceleration(radius) in rad/s^2. step_spin()
/// takes a step of dt s and is true where the spin ends.
template <class Effect>
concept SpinEffect = requires(const Effect& effect, MovingBall& ball) {
    effect.ends_spin();  // whether there is any
    effect.spin_deceleration(Real{});
    effect.step_spin(ball, Real{});
};

/// Drag, v' = -k v with k = drag_rate() (1/s): a step of dt s leaves the share drag_keeps(dt) of
/// the velocity; step_drag() takes it and is true where the ball stops, in closed form after
/// drag_time(speed) s.
template <class Effect>
concept DragEffect = requires(const Effect& effect, MovingBall& ball) {
    effect.drag_rate();
    effect.drag_keeps(Real{});
    effect.step_drag(ball, Real{});
    effect.drag_time(Real{});
};

/// Flight of balls above the cloth. step_flight() takes a step of dt s and is true where the ball
/// bounces; bounce() is the bounce of one that has come down.
template <class Effect>
concept FlightEffect = requires(const Effect& effect, MovingBall& ball) {
    effect.in_air(ball);
    effect.time_to_slate(ball);  // s
    effect.step_flight(ball, Real{});
    effect.bounce(ball);
    effect.clears_rail(ball);
};

/// A force on a ball that moves: push(ball, dt) changes its velocity and spin for a step of dt s,
/// after cloth and drag. It has no closed form, so only the stepping solvers take it.
template <class Effect>
concept ForceEffect = requires(const Effect& effect, MovingBall& ball) {
    effect.push(ball, Real{});
};

/// The same as types, by which a set is asked: Set::template kHook<hooks::Slip>.
namespace hooks {

template <class Effect>
struct Slip : std::bool_constant<SlipEffect<Effect>> {};

template <class Effect>
struct Roll : std::bool_constant<RollEffect<Effect>> {};

template <class Effect>
struct Spin : std::bool_constant<SpinEffect<Effect>> {};

template <class Effect>
struct Drag : std::bool_constant<DragEffect<Effect>> {};

template <class Effect>
struct Flight : std::bool_constant<FlightEffect<Effect>> {};

}  // namespace hooks

}  // namespace poolhall
