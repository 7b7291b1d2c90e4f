#include "shared/match/history.hpp"
#include "tests/shared/match/matches.hpp"

#include <gtest/gtest.h>

namespace poolhall {
namespace {

using namespace test;

TEST(MatchHistory, HasThePositionBeforeTheFirstMove) {
    Match match(end_game_match());
    const Position begin = match.now();
    EXPECT_EQ(begin, match.at(0));
    make(match, Seat{0}, kPass);
    EXPECT_EQ(begin, match.at(0));
}

TEST(MatchHistory, GivesEachMovesStepAgain) {
    Match match(end_game_match());
    const MatchStep placed = make(match, Seat{0}, Place{{end_game::kBaseLineX, 0.1}});
    const MatchStep shot_taken = make(match, Seat{0}, kPass);
    const MatchStep again = match.step(1);
    EXPECT_EQ(placed.made, match.step(0).made);
    EXPECT_EQ(shot_taken.made, again.made);
    EXPECT_EQ(shot_taken.after, again.after);
    ASSERT_NE(nullptr, again.shot());
    EXPECT_EQ(shot_taken.shot()->simulated.trace.hash, again.shot()->simulated.trace.hash);
    EXPECT_EQ(shot_taken.shot()->simulated.scene, again.shot()->simulated.scene);
}

TEST(MatchHistory, KeepsAPositionEverySoManyMovesAndWhereItIsTold) {
    Position position;
    MatchHistory history(position);
    const auto kept_for = [&](std::size_t moves) { return history.last_kept(moves).moves; };
    for (std::uint32_t i = 1; i <= 2 * MatchHistory::kSpacing; ++i) {
        position.shots = i;
        history.add({}, position);
    }
    EXPECT_EQ(0U, kept_for(MatchHistory::kSpacing - 1));
    EXPECT_EQ(MatchHistory::kSpacing, kept_for(MatchHistory::kSpacing));
    EXPECT_EQ(MatchHistory::kSpacing, kept_for(2 * MatchHistory::kSpacing - 1));
    position.wins = {7, 7};
    history.keep(position);
    EXPECT_EQ(position, history.last_kept(2 * MatchHistory::kSpacing).position)
        << "the later of two positions after the same move";
    history.add({}, position);
    history.keep(position);
    EXPECT_EQ(2 * MatchHistory::kSpacing + 1, kept_for(2 * MatchHistory::kSpacing + 1));
}

}  // namespace
}  // namespace poolhall
