#pragma once

#include <string_view>

namespace poolhall {

/// What the End Game keeps of itself.
struct EndGamePart {
    static constexpr std::string_view kType = "end_game";
    bool in_hand = true;  ///< the cue ball may be moved along the base line: before the first shot

    friend bool operator==(const EndGamePart&, const EndGamePart&) = default;
};

}  // namespace poolhall
