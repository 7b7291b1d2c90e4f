#pragma once

#include "shared/physics/motion/moving_ball.hpp"
#include "shared/physics/scene/scene.hpp"

namespace poolhall {

/// Friction of the cloth on a ball that slips: constant in size, against the slip
/// u = (vx - R wy, vy + R wx) of the point of contact. Along u the centre decelerates with mu g and
/// the slip shrinks 7/2 as fast, since friction also turns the ball: dw = 5 mu g / (2 R) z x u^.
/// The direction of u stays, so the centre runs on a parabola.
/// Source: Marlow, "The Physics of Pocket Billiards", 1995; Leckie and Greenspan, "An event-based
/// pool physics simulator", 2006.
class Sliding {
  public:
    explicit Sliding(const Scene& scene)
        : mu_g_(called_for(scene) ? scene.effects.sliding->mu * scene.gravity : 0) {}

    [[nodiscard]] static bool called_for(const Scene& scene) {
        return scene.effects.sliding && scene.effects.sliding->mu * scene.gravity > 0;
    }

    [[nodiscard]] bool active() const { return mu_g_ > 0; }

    /// Slip of the point that touches the cloth, m/s.
    [[nodiscard]] static Vec2 slip(const MovingBall& ball) {
        return {ball.v.x - ball.radius * ball.w.y, ball.v.y + ball.radius * ball.w.x};
    }

    /// The spin about the horizontal axes with which a ball rolls, rad/s.
    [[nodiscard]] static Vec2 rolling_spin(Vec2 v, Real radius) {
        return {-v.y / radius, v.x / radius};
    }

    /// The velocity at which the slip has gone, whatever mu is: v - 2/7 u.
    [[nodiscard]] static Vec2 velocity_after(Vec2 v, Vec2 slip) { return v - (Real{2} / 7) * slip; }

    [[nodiscard]] Real deceleration() const { return mu_g_; }  ///< m/s^2

    /// How long a slip of this speed (m/s) lasts, s.
    [[nodiscard]] Real duration(Real slip_speed) const { return 2 * slip_speed / (7 * mu_g_); }

    /// Angular acceleration, rad/s^2, for a slip along the unit vector.
    [[nodiscard]] Vec2 spin_rate(Vec2 slip_direction, Real radius) const {
        const Real rate = 5 * mu_g_ / (2 * radius);
        return {-rate * slip_direction.y, rate * slip_direction.x};
    }

    /// Takes an impulse of the cloth, per mass of the ball (m/s), from its velocity; the spin
    /// changes with it.
    static void rub(MovingBall& ball, Vec2 impulse) {
        ball.v = ball.v - impulse;
        const Real turn = 5 / (2 * ball.radius);
        ball.w.x = ball.w.x - turn * impulse.y;
        ball.w.y = ball.w.y + turn * impulse.x;
    }

    /// What friction takes from the velocity of a ball that slips in dt s, m/s.
    [[nodiscard]] Real lost_in(Real dt) const { return mu_g_ * dt; }

    /// An explicit Euler step of a ball that slips, in which friction takes that. The slip never
    /// turns round: where it would, the ball rolls from here on, and the step says true.
    [[nodiscard]] static bool kick(MovingBall& ball, Real lost) {
        const Vec2 u = slip(ball);
        const Real speed = norm(u);
        if (7 * lost >= 2 * speed) {
            ball.v = velocity_after(ball.v, u);
            return true;
        }
        const Vec2 impulse = (lost / speed) * u;
        rub(ball, impulse);
        return false;
    }

  private:
    Real mu_g_;  ///< m/s^2
};

}  // namespace poolhall
