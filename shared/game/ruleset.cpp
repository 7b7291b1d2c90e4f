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

}  // namespace poolhall
