#pragma once

#include "shared/fields.hpp"
#include "shared/physics/effects/prospect.hpp"
#include "shared/physics/effects/scene_like.hpp"
#include "shared/physics/motion/moving_ball.hpp"
#include "shared/table/bounds.hpp"

#include <optional>
#include <string_view>
#include <tuple>

namespace poolhall {

/// What a scene says of it. A coefficient of 0 means the same as none.
struct SpinDecaySpec {
    Real mu = 0.0127;  ///< spin about the vertical axis falls with 5 mu g / (2 R)

    static constexpr auto field_list() {
        return std::tuple{fields::of("mu", &SpinDecaySpec::mu, kFrictions).or_default()};
    }

    friend constexpr bool operator==(const SpinDecaySpec&, const SpinDecaySpec&) = default;
};

/// Its place among the effects of a scene.
struct SpinDecayPart {
    std::optional<SpinDecaySpec> spin_decay;

    static constexpr auto part_field() {
        return fields::of("spin_decay", &SpinDecayPart::spin_decay).hashed_if_absent();
    }

    friend constexpr bool operator==(const SpinDecayPart&, const SpinDecayPart&) = default;
};

/// Friction on spin about the vertical axis: |wz| falls with 5 mu g / (2 R) down to 0. It moves no
/// centre. Source: Marlow, 1995.
class SpinDecay {
  public:
    using Part = SpinDecayPart;
    static constexpr std::string_view kName = "spin_decay";

    explicit SpinDecay(const SceneLike auto& scene)
        : torque_(called_for(scene) ? 5 * (scene.effects.spin_decay->mu * scene.gravity) : 0) {}

    [[nodiscard]] static bool called_for(const SceneLike auto& scene) {
        return scene.effects.spin_decay && scene.effects.spin_decay->mu * scene.gravity > 0;
    }

    [[nodiscard]] static std::optional<Bound> ruled_out(const SceneLike auto& /*scene*/,
                                                        const Prospect& prospect) {
        return Prospect::unless(prospect.side_spin, Bound::kNoSideSpin);
    }

    [[nodiscard]] static bool acts_on(const SceneLike auto& /*scene*/, const BallState& state,
                                      Real /*radius*/) {
        return state.w.z != 0;
    }

    [[nodiscard]] bool ends_spin() const { return torque_ > 0; }

    /// rad/s^2
    [[nodiscard]] Real spin_deceleration(Real radius) const { return torque_ / (2 * radius); }

    /// A step of dt (s), which is exact. True where the spin ends.
    [[nodiscard]] bool step_spin(MovingBall& ball, Real dt) const {
        const Real lost = spin_deceleration(ball.radius) * dt;
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
