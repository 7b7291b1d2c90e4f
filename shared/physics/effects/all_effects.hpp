#pragma once

#include "shared/physics/contact/ball_ball.hpp"
#include "shared/physics/contact/rail_spec.hpp"
#include "shared/physics/effects/airborne.hpp"
#include "shared/physics/effects/effect_set.hpp"
#include "shared/physics/effects/end_game_pockets.hpp"
#include "shared/physics/effects/linear_drag.hpp"
#include "shared/physics/effects/parts.hpp"
#include "shared/physics/effects/pocket_circles.hpp"
#include "shared/physics/effects/pool_mouths.hpp"
#include "shared/physics/effects/rails.hpp"
#include "shared/physics/effects/rolling.hpp"
#include "shared/physics/effects/sliding.hpp"
#include "shared/physics/effects/spin_decay.hpp"

#include <tuple>

namespace poolhall {

/// Every effect that there is. A new one is one file and one line here; README.md says more.
using AllEffects = std::tuple<LinearDrag,  //
                              Sliding, Rolling, SpinDecay, Airborne, Rails, EndGamePockets,
                              PocketCircles, PoolMouths>;

/// The parameters of the effects that a scene calls for: scene.effects.sliding and so on. What is
/// absent is not simulated, and a coefficient of 0 means the same as absent. The models of impacts
/// are always there.
struct Effects : PartsOf<AllEffects>, BallBallPart, RailPart {
    static constexpr auto field_list() {
        return std::tuple_cat(PartsOf<AllEffects>::part_fields(),
                              std::tuple{BallBallPart::part_field(), RailPart::part_field()});
    }

    friend constexpr bool operator==(const Effects&, const Effects&) = default;
};

/// Friction of the cloth on a ball that slips, 0 where the scene calls for none.
[[nodiscard]] Real slip_friction(const SceneLike auto& scene) {
    return [&]<class... Effect>(std::type_identity<std::tuple<Effect...>>) {
        Real friction = 0;
        const auto add = [&]<class One>(std::type_identity<One>) {
            if constexpr (requires { One::slip_friction(scene); })
                friction = One::slip_friction(scene);
        };
        (add(std::type_identity<Effect>{}), ...);
        return friction;
    }(std::type_identity<AllEffects>{});
}

/// Whether an effect that the scene calls for can press two balls together.
[[nodiscard]] bool presses_balls(const SceneLike auto& scene) {
    return [&]<class... Effect>(std::type_identity<std::tuple<Effect...>>) {
        const auto presses = [&]<class One>(std::type_identity<One>) {
            if constexpr (requires { One::kPressesBalls; }) return One::called_for(scene);
            return false;
        };
        return (presses(std::type_identity<Effect>{}) || ...);
    }(std::type_identity<AllEffects>{});
}

}  // namespace poolhall
