#pragma once

#include "shared/physics/moving_ball.hpp"
#include "shared/physics/scene.hpp"

namespace poolhall {

/// Friction on spin about the vertical axis: |wz| falls with 5 mu g / (2 R) down to 0. It moves no
/// centre. Source: Marlow, 1995.
class SpinDecay {
  public:
    explicit SpinDecay(const Scene& scene)
        : mu_g_(called_for(scene) ? scene.effects.spin_decay->mu * scene.gravity : 0) {}

    [[nodiscard]] static bool called_for(const Scene& scene) {
        return scene.effects.spin_decay && scene.effects.spin_decay->mu * scene.gravity > 0;
    }

    [[nodiscard]] bool active() const { return mu_g_ > 0; }

    /// rad/s^2
    [[nodiscard]] Real rate(Real radius) const { return 5 * mu_g_ / (2 * radius); }

    /// The spin wz (rad/s) after dt (s).
    [[nodiscard]] Real after(Real spin, Real radius, Real dt) const {
        const Real lost = rate(radius) * dt;
        if (spin > lost) return spin - lost;
        return spin < -lost ? spin + lost : 0;
    }

  private:
    Real mu_g_;  ///< m/s^2
};

}  // namespace poolhall
