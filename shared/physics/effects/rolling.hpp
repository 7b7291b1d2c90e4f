#pragma once

#include "shared/physics/motion/moving_ball.hpp"
#include "shared/physics/scene/scene.hpp"

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

    /// What a ball that rolls loses of its speed in dt s, m/s.
    [[nodiscard]] Real lost_in(Real dt) const { return mu_g_ * dt; }

    /// An explicit Euler step of a ball that rolls, in which it loses that. True where it stops.
    [[nodiscard]] static bool kick(MovingBall& ball, Real lost) {
        const Real speed = norm(ball.v);
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
