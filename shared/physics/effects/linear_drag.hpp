#pragma once

#include "shared/math/elementary.hpp"
#include "shared/physics/motion/arc.hpp"
#include "shared/physics/scene/scene.hpp"

#include <algorithm>

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

    /// What is left of a velocity after an explicit Euler step of dt (s), its part.
    [[nodiscard]] Real kept_in(Real dt) const { return 1 - k_ * dt; }

    /// An explicit Euler step, after which that is left. True where the ball stops.
    [[nodiscard]] bool kick(MovingBall& ball, Real kept) const {
        ball.v = kept * ball.v;
        return !(dot(ball.v, ball.v) >= watched_square_) && stops(ball);
    }

  private:
    /// Stops a ball that is slow enough, and says so. Apart from kick(), which would otherwise keep
    /// in registers at every step what this needs at the last.
    [[nodiscard, gnu::noinline]] bool stops(MovingBall& ball) const {
        if (!(dot(ball.v, ball.v) < stop_speed_ * stop_speed_) && ball.v != Vec2{}) return false;
        ball.v = {};
        return true;
    }

    /// (m/s)^2; a square below may be that of a ball that stops nowhere, rounded to 0.
    static constexpr Real kTiny = 0x1p-960;

    Real k_;           ///< 1/s
    Real stop_speed_;  ///< m/s
    /// Below it stops() is asked, (m/s)^2.
    Real watched_square_ = std::max(stop_speed_ * stop_speed_, kTiny);
};

}  // namespace poolhall
