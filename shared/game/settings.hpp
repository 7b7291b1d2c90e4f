#pragma once

#include "shared/game/ruleset.hpp"

#include <optional>

namespace poolhall {

/// What a match may choose of its game's physics. What is absent is the game's own.
struct GameSettings {
    std::optional<Effects> effects;  ///< all of them: one that is left out is not simulated
    std::optional<SolverSpec> solver;

    friend bool operator==(const GameSettings&, const GameSettings&) = default;
};

// Bounds of the settings, within those of any scene. They let the balls of every shot come to rest
// while people watch, and keep what a shot costs to milliseconds.
inline constexpr double kMaxGameHz = 1000;           ///< of a solver with ticks
inline constexpr double kLeastGameFriction = 3e-3;   ///< of sliding, rolling and spin_decay, if any
inline constexpr double kLeastGameDrag = 0.1;        ///< 1/s
inline constexpr double kLeastGameStopSpeed = 1e-3;  ///< m/s
inline constexpr double kMaxGameStopSpeed = 0.5;     ///< m/s
/// Where a shot of a game with settings ends at the latest: what it holds can be sent and watched.
inline constexpr Limits kGameLimits{120, 500};

/// The first thing that makes the settings unfit for a game by these rules: what no scene may have,
/// balls that would not come to rest, too many ticks. The pointer is into the settings' JSON form,
/// which is that of a scene: "/effects/rolling/mu".
[[nodiscard]] std::optional<SceneError> check(const Ruleset& rules, const GameSettings& settings);

/// The rules' new game under these settings, which must have passed check(). With none it is the
/// rules' own to the last bit; with any, a shot ends at kGameLimits.
[[nodiscard]] GameState new_game(const Ruleset& rules, Seat first, const GameSettings& settings);

}  // namespace poolhall
