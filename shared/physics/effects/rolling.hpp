#pragma once

#include "shared/fields.hpp"
#include "shared/physics/effects/scene_like.hpp"
#include "shared/physics/motion/moving_ball.hpp"
#include "shared/physics/motion/slip.hpp"
#include "shared/table/bounds.hpp"

#include <optional>
#include <string_view>
#include <tuple>

namespace poolhall {

/// What a scene says of it. A coefficient of 0 means the same as none.
struct RollingSpec {
    Real mu = 0.01;  ///< rolling resistance: deceleration over gravity

    static constexpr auto field_list() {
        return std::tuple{fields::of("mu", &RollingSpec::mu, kFrictions).or_default()};
    }

    friend constexpr bool operator==(const RollingSpec&, const RollingSpec&) = default;
};

/// Its place among the effects of a scene.
struct RollingPart {
    std::optional<RollingSpec> rolling;

    static constexpr auto part_field() {
        return fields::of("rolling", &RollingPart::rolling).hashed_if_absent();
    }

    friend constexpr bool operator==(const RollingPart&, const RollingPart&) = default;
};

/// Rolling resistance: a ball that rolls decelerates with mu g along its velocity, so it runs
/// straight and stops after v / (mu g) s and v^2 / (2 mu g) m. Source: Marlow, 1995.
class Rolling {
  public:
    using Part = RollingPart;
    static constexpr std::string_view kName = "rolling";
    static constexpr bool kPressesBalls = true;

    explicit Rolling(const SceneLike auto& scene)
        : mu_g_(called_for(scene) ? scene.effects.rolling->mu * scene.gravity : 0) {}

    [[nodiscard]] static bool called_for(const SceneLike auto& scene) {
        return scene.effects.rolling && scene.effects.rolling->mu * scene.gravity > 0;
    }

    [[nodiscard]] static bool acts_on(const SceneLike auto& scene, const BallState& state,
                                      Real radius) {
        return xy(state.v) != Vec2{} && state.r.z == 0 &&
               (slip_friction(scene) == 0 || !slips(state, radius));
    }

    [[nodiscard]] Real roll_deceleration() const { return mu_g_; }  ///< m/s^2

    /// What a ball that rolls loses of its speed in dt s, m/s.
    [[nodiscard]] Real roll_loss(Real dt) const { return mu_g_ * dt; }

    /// An explicit Euler step of a ball that rolls, in which it loses that. True where it stops.
    [[nodiscard]] static bool step_roll(MovingBall& ball, Real lost) {
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
