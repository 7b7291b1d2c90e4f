#pragma once

#include "protocol/wire/scene_fields.hpp"
#include "shared/game/settings.hpp"

#include <tuple>

// The settings of a match, as in create_match and in the replay: parts of poolhall.scene/1. Whether
// they are fit for a game is left to check() of settings.hpp.
namespace poolhall::protocol::wire {

template <>
inline constexpr auto kFields<GameSettings> = std::tuple{
    field("effects", &GameSettings::effects),
    field("solver", &GameSettings::solver),
};

}  // namespace poolhall::protocol::wire
