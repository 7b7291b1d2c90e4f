#pragma once

#include "shared/physics/contact/ball_ball.hpp"
#include "shared/physics/effects/prospect.hpp"
#include "shared/physics/effects/scene_like.hpp"
#include "shared/physics/motion/event_kind.hpp"

#include <optional>
#include <string_view>

namespace poolhall {

/// Friction between balls, which throws them and turns them. A model of impacts
/// (../contact/ball_friction.hpp), so it is in no kernel; accounts of a shot name it with the
/// effects.
struct Throw {
    static constexpr std::string_view kName = "throw";

    [[nodiscard]] static bool called_for(const SceneLike auto& scene) {
        return has_friction(scene.effects.ball_ball);
    }

    [[nodiscard]] static std::optional<Bound> ruled_out(const SceneLike auto& /*scene*/,
                                                        const Prospect& prospect) {
        return Prospect::unless(prospect.meets, Bound::kNoMeeting);
    }

    [[nodiscard]] static constexpr bool acts_in(EventKind kind) {
        return kind == EventKind::kBallBall;
    }
};

}  // namespace poolhall
