#pragma once

#include "shared/game/game_state.hpp"

#include <string>
#include <string_view>

namespace poolhall::client {

/// What the rules said, as a sentence without a full stop: "The 8-ball is down". `shooter` is
/// "You", or the name of whose move it was.
[[nodiscard]] std::string ruling_text(std::string_view game, const Ruling& ruling,
                                      const std::string& shooter);

}  // namespace poolhall::client
