#pragma once

#include "shared/game/game_state.hpp"

#include <optional>
#include <span>
#include <string_view>

namespace poolhall {

/// What a player may ask of the cue.
struct ShotCommand {
    Vec2 direction;  ///< of any length but zero; finite
};

/// Why the rules refuse something.
enum class Illegal : std::uint8_t {
    kGameOver,
    kNotPlaceable,  ///< the cue ball may not be moved now
    kOutOfPlace,    ///< not a place where it may be put
    kBadDirection,  ///< zero or not finite
};

constexpr auto enum_names(Illegal /*type*/) {
    return names_of<Illegal>({{Illegal::kGameOver, "game_over"},
                              {Illegal::kNotPlaceable, "not_placeable"},
                              {Illegal::kOutOfPlace, "out_of_place"},
                              {Illegal::kBadDirection, "bad_direction"}});
}

/// A game's rules as pure functions; nothing here keeps state. One value of this a game.
struct Ruleset {
    std::string_view name;  ///< "end_game"
    /// With the game's own physics; settings.hpp begins games with others.
    GameState (*new_game)(Seat first);
    /// Moves the cue ball to `position` (m), where and when the rules allow it.
    std::optional<Illegal> (*place_cue_ball)(GameState& state, Vec2 position);
    /// The nearest place to `position` at which the cue ball may be put; nothing if it may not be
    /// moved now.
    std::optional<Vec2> (*nearest_placement)(const GameState& state, Vec2 position);
    /// The direction that the aim takes by itself after each stop (not normalised).
    Vec2 (*default_aim)(const GameState& state);
    /// Refuses without a change, or nothing.
    std::optional<Illegal> (*check_shot)(const GameState& state, const ShotCommand& command);
    /// Simulates the shot, to rest or to a limit of the scene, and rules on it; the state after it
    /// is at rest in either case. The command must have passed check_shot.
    ShotOutcome (*play)(const GameState& state, const ShotCommand& command);
};

[[nodiscard]] std::span<const Ruleset* const> all_rulesets();
[[nodiscard]] const Ruleset* find_ruleset(std::string_view name);

}  // namespace poolhall
