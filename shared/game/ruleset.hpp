#pragma once

#include "shared/game/game_state.hpp"
#include "shared/game/legal.hpp"
#include "shared/game/move.hpp"
#include "shared/physics/scene/trace.hpp"

#include <optional>
#include <span>
#include <string_view>

namespace poolhall {

/// A shot as it was simulated.
struct SimulatedShot {
    Scene scene;  ///< that of the state before it, with the strike
    ShotTrace trace;
};

/// What a move has made of a game.
struct Turn {
    GameState state;                    ///< after it, at rest
    std::optional<Ruling> ruling;       ///< none where the same seat just goes on: a placement
    std::optional<SimulatedShot> shot;  ///< if the move was one
};

/// A game's rules as pure functions; nothing here keeps state. One value of this a game.
struct Ruleset {
    std::string_view name;  ///< "end_game"
    /// With the game's own physics; settings.hpp begins games with others.
    GameState (*new_game)(Seat first);
    Legal (*legal)(const GameState& state);
    /// The state after the move of the seat whose turn it is. Shots are simulated to rest or to a
    /// limit of the scene. The move must be one in which find_fault() finds nothing, completed().
    Turn (*play)(const GameState& state, const Move& move);
};

/// The rules of all games, in the order of GamePart.
[[nodiscard]] std::span<const Ruleset* const> all_rulesets();
[[nodiscard]] const Ruleset* find_ruleset(std::string_view name);

/// The seat gives the game up.
[[nodiscard]] Turn concede(const GameState& state, Seat seat);

}  // namespace poolhall
