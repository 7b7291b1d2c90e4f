#pragma once

#include "shared/physics/effects/prospect.hpp"
#include "shared/physics/effects/scene_like.hpp"
#include "shared/physics/motion/arc.hpp"
#include "shared/physics/motion/event_kind.hpp"
#include "shared/table/pockets.hpp"

#include <optional>
#include <string_view>

namespace poolhall {

/// The original game's pockets as an effect of a scene.
class EndGamePockets {
  public:
    static constexpr std::string_view kName = "end_game_pockets";

    explicit EndGamePockets(const SceneLike auto& scene)
        : map_(scene.table, scene.ball.radius), active_(called_for(scene)) {}

    [[nodiscard]] static bool called_for(const SceneLike auto& scene) {
        return scene.table.pockets == PocketModel::kEndGame;
    }

    /// All of them are near the long rails.
    [[nodiscard]] static std::optional<Bound> ruled_out(const SceneLike auto& scene,
                                                        const Prospect& prospect) {
        const Real near = EndGamePocketMap(scene.table, scene.ball.radius).near_rail_y();
        return Prospect::unless(!(prospect.reach.low_y > -near && prospect.reach.high_y < near),
                                Bound::kOutOfReach);
    }

    [[nodiscard]] static constexpr bool acts_in(EventKind kind) {
        return kind == EventKind::kBallPocket;
    }

    [[nodiscard]] std::optional<Capture> first_capture(Vec2 r, Vec2 v, Real time) const {
        return active_ ? map_.first_capture(r, v, time) : std::nullopt;
    }

    /// Up to which |x| and |y| a centre meets none of them, m.
    [[nodiscard]] Vec2 clear_area(Real /*radius*/) const {
        return {kNever, active_ ? map_.near_rail_y() : kNever};
    }

    /// The first capture on an arc; t in s from its beginning. Captures begin where |x| or |y|
    /// passes one of three lines, so between two such instants nothing changes.
    [[nodiscard]] std::optional<Capture> first_capture_on(const MovingBall& ball,
                                                          const Arc& arc) const;

    [[nodiscard]] std::optional<Pocket> at(Vec2 r) const {
        return active_ ? map_.at(r) : std::nullopt;
    }

  private:
    EndGamePocketMap map_;
    bool active_;
};

}  // namespace poolhall
