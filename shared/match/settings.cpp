#include "shared/match/settings.hpp"

#include <array>

namespace poolhall {

std::optional<SceneError> check(const Ruleset& rules, const MatchSettings& settings) {
    if (auto error = check(rules, settings.game)) return error;
    if (settings.race_to > kMaxRace) return SceneError{"/race_to", "must be at most 1000"};
    const auto clock = settings.shot_clock_s;
    if (clock && (*clock < kMinShotClock || *clock > kMaxShotClock))
        return SceneError{"/shot_clock_s", "must be from 5 to 3600"};
    return std::nullopt;
}

std::string_view name(BreakOrder order) {
    constexpr std::array<std::string_view, 3> kNames{"alternate", "winner", "loser"};
    return kNames[static_cast<std::size_t>(order)];
}

std::string_view name(Turns turns) {
    constexpr std::array<std::string_view, 2> kNames{"shared", "solo"};
    return kNames[static_cast<std::size_t>(turns)];
}

}  // namespace poolhall
