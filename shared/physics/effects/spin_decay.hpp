#pragma once

#include "shared/physics/motion/moving_ball.hpp"
#include "shared/physics/scene/scene.hpp"

namespace poolhall {

/// Friction on spin about the vertical axis: |wz| falls with 5 mu g / (2 R) down to 0. It moves no
/// centre. Source: Marlow, 1995.
class SpinDecay {
  public:
    explicit SpinDecay(const Scene& scene)
        : torque_(called_for(scene) ? 5 * (scene.effects.spin_decay->mu * scene.gravity) : 0) {}

    [[nodiscard]] static bool called_for(const Scene& scene) {
        return scene.effects.spin_decay && scene.effects.spin_decay->mu * scene.gravity > 0;
    }

    [[nodiscard]] bool active() const { return torque_ > 0; }

    /// rad/s^2
    [[nodiscard]] Real rate(Real radius) const { return torque_ / (2 * radius); }

    /// A step of dt (s), which is exact. True where the spin ends.
    [[nodiscard]] bool kick(MovingBall& ball, Real dt) const {
        const Real lost = rate(ball.radius) * dt;
        const Real spin = ball.w.z;
        if (spin > lost) {
            ball.w.z = spin - lost;
            return false;
        }
        if (spin < -lost) {
            ball.w.z = spin + lost;
            return false;
        }
        ball.w.z = 0;
        return true;
    }

  private:
    Real torque_;  ///< 5 mu g, m/s^2
};

}  // namespace poolhall
