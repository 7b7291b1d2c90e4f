#pragma once

#include "shared/fields.hpp"
#include "shared/math/elementary.hpp"
#include "shared/physics/effects/scene_like.hpp"
#include "shared/physics/motion/arc.hpp"
#include "shared/table/bounds.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <tuple>

namespace poolhall {

/// What a scene says of it. A k of 0 means the same as none.
struct LinearDragSpec {
    Real k = 0.6;              ///< 1/s: v' = -k v
    Real stop_speed = 0.0625;  ///< m/s: slower than this is at rest

    static constexpr double kMaxRate = 1e6;  ///< 1/s

    static constexpr auto field_list() {
        return std::tuple{fields::of("k", &LinearDragSpec::k, {0, kMaxRate}).in("1/s"),
                          fields::of("stop_speed", &LinearDragSpec::stop_speed, kSpeeds).in("m/s")};
    }

    friend constexpr bool operator==(const LinearDragSpec&, const LinearDragSpec&) = default;
};

/// Its place among the effects of a scene.
struct LinearDragPart {
    std::optional<LinearDragSpec> linear_drag;

    static constexpr auto part_field() {
        return fields::of("linear_drag", &LinearDragPart::linear_drag).hashed_if_absent();
    }

    friend constexpr bool operator==(const LinearDragPart&, const LinearDragPart&) = default;
};

/// The original game's friction: v' = -k v, and at rest below a stop speed. Not what cloth does
/// (that is Coulomb friction), but what the game feels like. Source: SAGE's Pool End Game,
/// CObject::Move, as an explicit Euler step. In closed form a ball runs straight and, in
/// s = (1 - exp(-k t)) / k, uniformly: r + v s. All balls share that clock.
class LinearDrag {
  public:
    using Part = LinearDragPart;
    static constexpr std::string_view kName = "linear_drag";

    explicit LinearDrag(const SceneLike auto& scene)
        : k_(called_for(scene) ? scene.effects.linear_drag->k : 0),
          stop_speed_(called_for(scene) ? scene.effects.linear_drag->stop_speed : 0) {}

    [[nodiscard]] static bool called_for(const SceneLike auto& scene) {
        return scene.effects.linear_drag && scene.effects.linear_drag->k > 0;
    }

    [[nodiscard]] static bool acts_on(const SceneLike auto& /*scene*/, const BallState& state,
                                      Real /*radius*/) {
        return xy(state.v) != Vec2{};
    }

    [[nodiscard]] Real drag_rate() const { return k_; }  ///< 1/s

    /// How long a ball of that speed (m/s) moves, s: ln(speed / stop speed) / k.
    [[nodiscard]] Real drag_time(Real speed) const {
        if (k_ == 0 || stop_speed_ == 0) return kNever;
        return speed > stop_speed_ ? elementary::log(speed / stop_speed_) / k_ : 0;
    }

    /// What is left of a velocity after an explicit Euler step of dt (s), its part.
    [[nodiscard]] Real drag_keeps(Real dt) const { return 1 - k_ * dt; }

    /// An explicit Euler step, after which that is left. True where the ball stops.
    [[nodiscard]] bool step_drag(MovingBall& ball, Real kept) const {
        ball.v = kept * ball.v;
        return !(dot(ball.v, ball.v) >= watched_square_) && stops(ball);
    }

  private:
    /// Stops a ball that is slow enough, and says so. Apart from step_drag(), which would otherwise
    /// keep in registers at every step what this needs at the last.
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
