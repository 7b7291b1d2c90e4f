#pragma once

#include "shared/fields.hpp"

#include <string_view>
#include <tuple>

namespace poolhall {

struct Ruleset;

/// What the End Game keeps of itself.
struct EndGamePart {
    static constexpr std::string_view kType = "end_game";
    [[nodiscard]] static const Ruleset& rules();

    bool in_hand = true;  ///< the cue ball may be moved along the base line: before the first shot

    static constexpr auto field_list() {
        return std::tuple{fields::of("in_hand", &EndGamePart::in_hand)};
    }

    friend bool operator==(const EndGamePart&, const EndGamePart&) = default;
};

}  // namespace poolhall
