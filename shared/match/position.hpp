#pragma once

#include "shared/game/game_state.hpp"
#include "shared/game/legal.hpp"

#include <cstdint>
#include <optional>

namespace poolhall {

/// Where a match stands between two moves; everything at rest.
struct Position {
    GameState game;
    Legal legal;                    ///< who may do what now
    std::uint32_t game_number = 1;  ///< from 1; a rematch is the next
    Seat first;                     ///< broke in this game
    std::uint32_t shots = 0;        ///< taken in the match
    PerSeat<std::uint32_t> wins{};  ///< games won in this race
    PerSeat<bool> consents{};       ///< to a rematch
    std::optional<Seat> winner;     ///< of the race, once it is over
    std::optional<Ruling> ruling;   ///< of the last turn of this game

    friend bool operator==(const Position&, const Position&) = default;
};

/// A move as the match took it.
struct MadeMove {
    Seat seat;
    Move move;                ///< completed()
    std::int64_t at_ms = 0;   ///< Unix time, or since any one moment; ms
    std::uint64_t state = 0;  ///< hash of the game's state after it

    friend bool operator==(const MadeMove&, const MadeMove&) = default;
};

}  // namespace poolhall
