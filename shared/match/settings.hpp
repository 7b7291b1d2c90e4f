#pragma once

#include "shared/enum_names.hpp"
#include "shared/game/settings.hpp"

#include <cstdint>
#include <optional>

namespace poolhall {

/// Who breaks in the game after one.
enum class BreakOrder : std::uint8_t { kAlternate, kWinner, kLoser };

constexpr auto enum_names(BreakOrder /*type*/) {
    return names_of<BreakOrder>({{BreakOrder::kAlternate, "alternate"},
                                 {BreakOrder::kWinner, "winner"},
                                 {BreakOrder::kLoser, "loser"}});
}

/// Whose turns they are.
enum class Turns : std::uint8_t {
    kShared,  ///< as the rules say
    kSolo,    ///< seat 0 takes every one, and a game lost is won by seat 1
};

constexpr auto enum_names(Turns /*type*/) {
    return names_of<Turns>({{Turns::kShared, "shared"}, {Turns::kSolo, "solo"}});
}

/// What is agreed on for all games of a match.
struct MatchSettings {
    GameSettings game;          ///< the physics
    std::uint32_t race_to = 0;  ///< games that win the match; 0: no end
    BreakOrder breaks = BreakOrder::kAlternate;
    std::optional<std::uint32_t> shot_clock_s = {};  ///< for each decision, s; none: no clock
    Turns turns = Turns::kShared;

    friend bool operator==(const MatchSettings&, const MatchSettings&) = default;
};

// Bounds that check() keeps.
inline constexpr std::uint32_t kMaxRace = 1000;
inline constexpr std::uint32_t kMinShotClock = 5;     ///< s
inline constexpr std::uint32_t kMaxShotClock = 3600;  ///< s

/// The first thing that makes the settings unfit for a match by these rules. The pointer is into
/// their JSON form, in which the game's settings are not nested: "/effects/rolling/mu", "/race_to".
[[nodiscard]] std::optional<SceneError> check(const Ruleset& rules, const MatchSettings& settings);

}  // namespace poolhall
