#pragma once

#include "shared/game/settings.hpp"
#include "shared/result.hpp"

#include <filesystem>
#include <string>

namespace poolhall::client {

/// Effects and solver of a file of schema poolhall.scene/1, standard input for "-", for games by
/// these rules; all else in the scene is left aside. The error is one line: the file, where in it,
/// and what is wrong.
[[nodiscard]] Result<GameSettings, std::string> read_physics(const std::filesystem::path& path,
                                                             const Ruleset& rules);

}  // namespace poolhall::client
