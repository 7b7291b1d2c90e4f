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
struct SlidingSpec {
    Real mu = 0.2;  ///< friction of the cloth on a ball that slips

    static constexpr auto field_list() {
        return std::tuple{fields::of("mu", &SlidingSpec::mu, kFrictions).or_default()};
    }

    friend constexpr bool operator==(const SlidingSpec&, const SlidingSpec&) = default;
};

/// Its place among the effects of a scene.
struct SlidingPart {
    std::optional<SlidingSpec> sliding;

    static constexpr auto part_field() {
        return fields::of("sliding", &SlidingPart::sliding).hashed_if_absent();
    }

    friend constexpr bool operator==(const SlidingPart&, const SlidingPart&) = default;
};

/// Friction of the cloth on a ball that slips: constant in size, against the slip
/// u = (vx - R wy, vy + R wx) of the point of contact. Along u the centre decelerates with mu g and
/// the slip shrinks 7/2 as fast, since friction also turns the ball: dw = 5 mu g / (2 R) z x u^.
/// The direction of u stays, so the centre runs on a parabola.
/// Source: Marlow, "The Physics of Pocket Billiards", 1995; Leckie and Greenspan, "An event-based
/// pool physics simulator", 2006.
class Sliding {
  public:
    using Part = SlidingPart;
    static constexpr std::string_view kName = "sliding";
    static constexpr bool kPressesBalls = true;

    explicit Sliding(const SceneLike auto& scene)
        : mu_g_(called_for(scene) ? scene.effects.sliding->mu * scene.gravity : 0) {}

    [[nodiscard]] static bool called_for(const SceneLike auto& scene) {
        return scene.effects.sliding && scene.effects.sliding->mu * scene.gravity > 0;
    }

    [[nodiscard]] static bool acts_on(const SceneLike auto& /*scene*/, const BallState& state,
                                      Real radius) {
        return slips(state, radius);
    }

    /// The coefficient of friction of a scene's cloth, 0 if none.
    [[nodiscard]] static Real slip_friction(const SceneLike auto& scene) {
        return called_for(scene) ? scene.effects.sliding->mu : 0;
    }

    [[nodiscard]] bool rubs() const { return mu_g_ > 0; }

    [[nodiscard]] Real slip_deceleration() const { return mu_g_; }  ///< m/s^2

    /// How long a slip of this speed (m/s) lasts, s.
    [[nodiscard]] Real slip_time(Real slip_speed) const { return 2 * slip_speed / (7 * mu_g_); }

    /// Angular acceleration, rad/s^2, for a slip along the unit vector.
    [[nodiscard]] Vec2 slip_spin_rate(Vec2 slip_direction, Real radius) const {
        const Real rate = 5 * mu_g_ / (2 * radius);
        return {-rate * slip_direction.y, rate * slip_direction.x};
    }

    /// What friction takes from the velocity of a ball that slips in dt s, m/s.
    [[nodiscard]] Real slip_loss(Real dt) const { return mu_g_ * dt; }

    /// An explicit Euler step of a ball that slips, in which friction takes that. The slip never
    /// turns round: where it would, the ball rolls from here on, and the step says true.
    [[nodiscard]] static bool step_slip(MovingBall& ball, Real lost) {
        const Vec2 u = slip_of(ball);
        const Real speed = norm(u);
        if (7 * lost >= 2 * speed) {
            ball.v = velocity_after_slip(ball.v, u);
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
