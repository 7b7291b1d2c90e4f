#include "shared/game/ruleset.hpp"

#include "shared/game/end_game.hpp"

#include <array>

namespace poolhall {

std::span<const Ruleset* const> all_rulesets() {
    static constexpr std::array<const Ruleset*, 1> kAll{&kEndGameRules};
    return kAll;
}

const Ruleset* find_ruleset(std::string_view name) {
    for (const Ruleset* rules : all_rulesets()) {
        if (rules->name == name) return rules;
    }
    return nullptr;
}

std::string_view name(Illegal reason) {
    constexpr std::array<std::string_view, 4> kNames{"game_over", "not_placeable", "out_of_place",
                                                     "bad_direction"};
    return kNames[static_cast<std::size_t>(reason)];
}

std::string_view name(Verdict verdict) {
    constexpr std::array<std::string_view, 3> kNames{"turn_passes", "won", "scratch"};
    return kNames[static_cast<std::size_t>(verdict)];
}

}  // namespace poolhall
