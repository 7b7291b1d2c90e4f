#include "shared/game/ruleset.hpp"

#include <array>
#include <type_traits>

namespace poolhall {

namespace {

template <class... Parts>
std::array<const Ruleset*, sizeof...(Parts)> rules_of(
    std::type_identity<std::variant<Parts...>> /*list*/) {
    return {&Parts::rules()...};
}

}  // namespace

std::span<const Ruleset* const> all_rulesets() {
    static const auto kAll = rules_of(std::type_identity<GamePart>{});
    return kAll;
}

const Ruleset* find_ruleset(std::string_view name) {
    for (const Ruleset* rules : all_rulesets()) {
        if (rules->name == name) return rules;
    }
    return nullptr;
}

Turn concede(const GameState& state, Seat seat) {
    Turn turn;
    turn.state = state;
    turn.state.over = true;
    turn.state.winner = opponent(seat);
    turn.ruling = Ruling{Verdict::kConceded, seat, opponent(seat), opponent(seat), 0};
    return turn;
}

}  // namespace poolhall
