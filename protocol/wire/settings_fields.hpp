#pragma once

#include "protocol/wire/scene_fields.hpp"
#include "shared/match/settings.hpp"

#include <tuple>

// The settings of a match, as in create_match and in the replay; effects and solver are parts of
// poolhall.scene/1. Whether they are fit for a game is left to check() of settings.hpp.
namespace poolhall::protocol::wire {

template <>
inline constexpr auto kFields<MatchSettings> = std::tuple{
    field(
        "effects", [](auto& settings) -> auto& { return settings.game.effects; },
        DefaultCodec<Effects>{}),
    field(
        "solver", [](auto& settings) -> auto& { return settings.game.solver; },
        Object<SolverSpec>{}),
    field("race_to", &MatchSettings::race_to).or_default(),
    field("breaks", &MatchSettings::breaks).or_default(),
    field("shot_clock_s", &MatchSettings::shot_clock_s),
    field("turns", &MatchSettings::turns).or_default(),
};

}  // namespace poolhall::protocol::wire
