#pragma once

#include "server/room/table.hpp"
#include "shared/game/end_game.hpp"

namespace poolhall::server::test {

inline constexpr MemberId kAda{1};
inline constexpr MemberId kBen{2};

inline Table empty_table(const MatchSettings& settings = {}) {
    return Table("0123456789abcdef", "BCDFGH", {&kEndGameRules, Seat{0}, settings});
}

/// Ada in seat 0, Ben in seat 1.
inline Table seated_table(const MatchSettings& settings = {}) {
    Table table = empty_table(settings);
    table.take_seat(Seat{0}, {"Ada", hash_token("a"), kAda});
    table.take_seat(Seat{1}, {"Ben", hash_token("b"), kBen});
    return table;
}

/// What comes of a shot of the seat whose turn it is.
inline MatchStep shot_step(const Table& table, Vec2 direction) {
    const Seat seat = table.match.now().legal.seat;
    return table.match.play(seat, Shoot{Stroke{direction, {}}}, 0);
}

}  // namespace poolhall::server::test
