#pragma once

#include "shared/fields.hpp"
#include "shared/physics/effects/prospect.hpp"
#include "shared/physics/effects/scene_like.hpp"
#include "shared/physics/motion/moving_ball.hpp"
#include "shared/physics/motion/slip.hpp"
#include "shared/table/bounds.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <tuple>

namespace poolhall {

/// What a scene says of it.
struct AirborneSpec {
    Real e_slate = 0.6;  ///< coefficient of restitution of ball and slate, 0 to 1

    static constexpr auto field_list() {
        return std::tuple{fields::of("e_slate", &AirborneSpec::e_slate, kShares).or_default()};
    }

    friend constexpr bool operator==(const AirborneSpec&, const AirborneSpec&) = default;
};

/// Its place among the effects of a scene.
struct AirbornePart {
    std::optional<AirborneSpec> airborne;

    static constexpr auto part_field() {
        return fields::of("airborne", &AirbornePart::airborne).hashed_if_absent();
    }

    friend constexpr bool operator==(const AirbornePart&, const AirbornePart&) = default;
};

/// Balls that leave the slate: jump shots. In the air there is only gravity; on the slate the ball
/// bounces with restitution e_slate, and friction acts on its slip, at most mu times the impulse
/// and never past the slip's end (2/7 of it). A bounce too low to matter ends the flight. Source:
/// impulse of a sphere on a plane, as at the rails; Alciatore, TP B.10 (jump shots).
class Airborne {
  public:
    using Part = AirbornePart;
    static constexpr std::string_view kName = "airborne";

    explicit Airborne(const SceneLike auto& scene)
        : e_(called_for(scene) ? scene.effects.airborne->e_slate : 0),
          gravity_(scene.gravity),
          mu_(slip_friction(scene)),
          rail_height_(scene.effects.rail.nose_height),
          active_(called_for(scene)) {}

    [[nodiscard]] static bool called_for(const SceneLike auto& scene) {
        return scene.effects.airborne.has_value();
    }

    /// Rails leave v.z alone, and so do impacts on the cloth of balls whose centres are at one
    /// height; a cue that slopes drives its ball into the slate.
    [[nodiscard]] static std::optional<Bound> ruled_out(const SceneLike auto& /*scene*/,
                                                        const Prospect& prospect) {
        return Prospect::unless(prospect.flies, Bound::kLevelCue);
    }

    [[nodiscard]] static bool acts_on(const SceneLike auto& /*scene*/, const BallState& state,
                                      Real /*radius*/) {
        return state.r.z > 0 || state.v.z != 0;
    }

    [[nodiscard]] bool in_air(const MovingBall& ball) const {
        return active_ && (ball.height > 0 || ball.climb != 0);
    }

    /// When the ball comes down on the slate, s; infinity without gravity.
    [[nodiscard]] Real time_to_slate(const MovingBall& ball) const {
        const Real height = std::max(ball.height, Real{0});
        const Real fall = sqrt(ball.climb * ball.climb + 2 * gravity_ * height);
        // Of the two ways to write the root, the one that adds.
        if (ball.climb > 0) return gravity_ > 0 ? (ball.climb + fall) / gravity_ : kInfinity;
        if (fall - ball.climb > 0) return 2 * height / (fall - ball.climb);
        return kInfinity;
    }

    /// Whether a ball that comes to a rail passes over its nose.
    [[nodiscard]] bool clears_rail(const MovingBall& ball) const {
        return ball.motion == Motion::kAirborne && ball.height >= rail_height_;
    }

    /// A step of dt (s) of its velocity. True where the ball bounces; it is not pulled down then.
    [[nodiscard]] bool step_flight(MovingBall& ball, Real dt) const {
        if (ball.height <= 0 && ball.climb < 0) {
            ball.height = 0;
            // A flight of whole ticks ends as fast as it began and up to a tick's fall more: with
            // that the ball would bounce forever.
            ball.climb = std::min(ball.climb + gravity_ * dt, Real{0});
            bounce(ball);
            return true;
        }
        ball.climb = ball.climb - gravity_ * dt;
        return false;
    }

    /// The bounce of a ball that has come down with climb < 0.
    void bounce(MovingBall& ball) const {
        const Real impact = -ball.climb;
        const Real rebound = e_ * impact;
        ball.climb = rebound < kLeastRebound ? 0 : rebound;
        const Vec2 slip = slip_of(ball);
        const Real speed = norm(slip);
        if (speed == 0) return;
        const Real friction = std::min(mu_ * (impact + ball.climb), 2 * speed / 7);
        rub(ball, (friction / speed) * slip);
    }

  private:
    /// A rebound of this speed rises 0.02 mm, m/s.
    static constexpr Real kLeastRebound = 0.02;

    Real e_;
    Real gravity_;
    Real mu_;
    Real rail_height_;  ///< m
    bool active_;
};

}  // namespace poolhall
