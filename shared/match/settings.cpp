#include "shared/match/settings.hpp"

namespace poolhall {

std::optional<SceneError> check(const Ruleset& rules, const MatchSettings& settings) {
    if (auto error = check(rules, settings.game)) return error;
    if (settings.race_to > kMaxRace) return SceneError{"/race_to", "must be at most 1000"};
    const auto clock = settings.shot_clock_s;
    if (clock && (*clock < kMinShotClock || *clock > kMaxShotClock))
        return SceneError{"/shot_clock_s", "must be from 5 to 3600"};
    return std::nullopt;
}

}  // namespace poolhall
