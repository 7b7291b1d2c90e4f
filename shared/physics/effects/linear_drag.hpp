#pragma once

#include "shared/math/elementary.hpp"
#include "shared/physics/arc.hpp"
#include "shared/physics/scene.hpp"

namespace poolhall {

/// The original game's friction: v' = -k v, and at rest below a stop speed. Not what cloth does
/// (that is Coulomb friction), but what the game feels like. Source: SAGE's Pool End Game,
/// CObject::Move, as an explicit Euler step. In closed form a ball runs straight and, in
/// s = (1 - exp(-k t)) / k, uniformly: r + v s. All balls share that clock.
class LinearDrag {
  public:
    explicit LinearDrag(const Scene& scene)
        : k_(called_for(scene) ? scene.effects.linear_drag->k : 0),
          stop_speed_(called_for(scene) ? scene.effects.linear_drag->stop_speed : 0) {}

    [[nodiscard]] static bool called_for(const Scene& scene) {
        return scene.effects.linear_drag && scene.effects.linear_drag->k > 0;
    }

    [[nodiscard]] Real k() const { return k_; }  ///< 1/s

    /// How long a ball of that speed (m/s) moves, s: ln(speed / stop speed) / k.
    [[nodiscard]] Real time_to_rest(Real speed) const {
        if (k_ == 0 || stop_speed_ == 0) return kNever;
        return speed > stop_speed_ ? elementary::log(speed / stop_speed_) / k_ : 0;
    }

    /// The velocity (m/s) after an explicit Euler step of dt (s).
    [[nodiscard]] Vec2 euler_step(Vec2 v, Real dt) const {
        const Vec2 next = (1 - k_ * dt) * v;
        return dot(next, next) < stop_speed_ * stop_speed_ ? Vec2{} : next;
    }

  private:
    Real k_;           ///< 1/s
    Real stop_speed_;  ///< m/s
};

}  // namespace poolhall
