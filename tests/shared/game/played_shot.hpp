#pragma once

#include "shared/game/ruleset.hpp"

#include <utility>

namespace poolhall::test {

/// A shot and all that came of it.
struct PlayedShot {
    Scene scene;  ///< with the strike
    ShotTrace trace;
    Ruling ruling;
    GameState state;  ///< after it
};

/// The seat whose turn it is shoots in this direction, with what else the game has of its own.
inline PlayedShot shoot(const Ruleset& rules, const GameState& state, Vec2 direction) {
    Shoot move;
    move.strike.direction = direction;
    Turn turn = rules.play(state, completed(rules.legal(state), move));
    SimulatedShot shot = std::move(turn.shot).value();
    return {std::move(shot.scene), std::move(shot.trace), turn.ruling.value(),
            std::move(turn.state)};
}

}  // namespace poolhall::test
