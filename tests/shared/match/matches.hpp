#pragma once

#include "shared/game/end_game.hpp"
#include "shared/match/match.hpp"

#include <gtest/gtest.h>
#include <utility>

// Matches to play in tests, by moves that are known to lead somewhere.
namespace poolhall::test {

inline constexpr std::int64_t kNow = 1'000'000;  ///< ms; any one moment

inline MatchSpec end_game_match(const MatchSettings& settings = {}, Seat first = Seat{0}) {
    return {&kEndGameRules, first, settings};
}

/// A shot in this direction, with all else left to the game.
inline Move shot(Vec2 direction) {
    Shoot move;
    move.strike.direction = direction;
    return move;
}

/// From the first position of an End Game: away from the 8-ball, along the table. Sinks nothing.
inline const Move kPass = shot({-1, 0});

/// Plays the move and takes it; what it made.
inline MatchStep make(Match& match, Seat seat, const Move& move, std::int64_t at_ms = kNow) {
    EXPECT_FALSE(match.find_fault(seat, move, at_ms));
    MatchStep step = match.play(seat, move, at_ms);
    match.commit(step, at_ms);
    return step;
}

/// The seat gives the game up.
inline MatchStep concede(Match& match, Seat seat) {
    return make(match, seat, Concede{});
}

/// Both seats want another game; it begins.
inline MatchStep rematch(Match& match) {
    make(match, Seat{0}, Agree{});
    return make(match, Seat{1}, Agree{});
}

/// A game that the seat wins, as it is given to it, and the next one begun.
inline void win(Match& match, Seat winner) {
    concede(match, opponent(winner));
    rematch(match);
}

/// The kinds of a step's events, in their order.
template <class... Events>
void expect_events(const MatchStep& step) {
    ASSERT_EQ(sizeof...(Events), step.events.size());
    std::size_t i = 0;
    const auto is_next = [&](bool holds) { EXPECT_TRUE(holds) << "event " << i - 1; };
    (is_next(std::holds_alternative<Events>(step.events[i++])), ...);
}

}  // namespace poolhall::test
