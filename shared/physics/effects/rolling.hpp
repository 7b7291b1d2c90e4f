#pragma once

#include "shared/physics/moving_ball.hpp"
#include "shared/physics/scene.hpp"

namespace poolhall {

/// Rolling resistance: a ball that rolls decelerates with mu g along its velocity, so it runs
/// straight and stops after v / (mu g) s and v^2 / (2 mu g) m. Source: Marlow, 1995.
class Rolling {
  public:
    explicit Rolling(const Scene& scene)
        : mu_g_(called_for(scene) ? scene.effects.rolling->mu * scene.gravity : 0) {}

    [[nodiscard]] static bool called_for(const Scene& scene) {
        return scene.effects.rolling && scene.effects.rolling->mu * scene.gravity > 0;
    }

    [[nodiscard]] Real deceleration() const { return mu_g_; }  ///< m/s^2

    /// An explicit Euler step of dt (s) of a ball that rolls. True where it stops.
    [[nodiscard]] bool kick(MovingBall& ball, Real dt) const {
        const Real speed = norm(ball.v);
        const Real lost = mu_g_ * dt;
        if (lost >= speed) {
            // The square of a speed below 1e-162 m/s is 0.
            if (lost == 0) return false;
            ball.v = {};
            return true;
        }
        ball.v = ball.v - (lost / speed) * ball.v;
        return false;
    }

  private:
    Real mu_g_;  ///< m/s^2
};

}  // namespace poolhall
