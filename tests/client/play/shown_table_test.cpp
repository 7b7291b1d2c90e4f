#include "client/play/shown_table.hpp"

#include "client/play/local_match.hpp"
#include "tests/client/play/fixtures.hpp"

#include <gtest/gtest.h>

namespace poolhall::client {
namespace {

class ShownTableTest : public ::testing::Test {
  protected:
    void shoot(Vec2 direction) {
        match_.make(Shoot{{.direction = direction}});
        pass(0);
    }

    /// True if the result has come into sight, or gone.
    bool pass(double seconds) {
        playback_.advance(seconds);
        return show();
    }

    bool show() {
        for (const auto& passed : playback_.take_passed())
            shown_.pass(passed);
        return shown_.refresh();
    }

    Playback playback_{Pacing::kSteady};
    LocalMatch match_{practice_spec(kEndGameRules), {"Anna", "The house"}, playback_};
    ShownTable shown_{match_, playback_};
};

TEST_F(ShownTableTest, NobodyActsWhileAShotIsShown) {
    shown_.refresh();
    EXPECT_EQ(shown_.acting_seat(), Seat{0});
    shoot(kStraight);
    EXPECT_EQ(shown_.acting_seat(), std::nullopt);
    pass(60);
    EXPECT_EQ(shown_.acting_seat(), Seat{0});
}

TEST_F(ShownTableTest, ScoreWaitsUntilTheShotHasBeenSeen) {
    shown_.refresh();
    shoot(direction_with(Verdict::kWon));
    EXPECT_EQ(shown_.table()->seats[0].wins, 0U);
    EXPECT_FALSE(shown_.result());
    EXPECT_TRUE(pass(60)) << "the result is news";
    EXPECT_EQ(shown_.table()->seats[0].wins, 1U);
    EXPECT_TRUE(shown_.result());
    EXPECT_FALSE(pass(1)) << "and is none the next time";
    match_.make(Agree{});
    EXPECT_TRUE(show()) << "it is gone with the next game";
}

TEST_F(ShownTableTest, SunkBallStaysInSightUntilTheNextGame) {
    shown_.refresh();
    shoot(direction_with(Verdict::kWon));
    pass(60);
    ASSERT_EQ(shown_.balls().size(), 2U);
    EXPECT_TRUE(shown_.balls()[1].sunk);
    match_.make(Agree{});
    show();
    EXPECT_FALSE(shown_.balls()[1].sunk);
}

TEST_F(ShownTableTest, EverythingOfAShotFollowsTimeInBothDirections) {
    shown_.refresh();
    shoot(direction_with(Verdict::kScratch));
    const double end = playback_.shot()->timeline.known_until();
    playback_.seek(0);
    show();
    const auto first = shown_.balls();
    playback_.seek(end);
    show();
    EXPECT_TRUE(shown_.balls()[0].sunk && shown_.cue_ball_is_down() && shown_.result());
    const auto marks = shown_.collision_marks().size();
    playback_.seek(0);
    EXPECT_TRUE(show()) << "the result is gone again";
    EXPECT_FALSE(shown_.cue_ball_is_down() || shown_.result());
    EXPECT_EQ(shown_.balls()[0].r, first[0].r);
    EXPECT_FALSE(shown_.balls()[0].sunk);
    EXPECT_TRUE(shown_.collision_marks().empty());
    pass(60);
    EXPECT_EQ(shown_.collision_marks().size(), marks) << "those of the last shot stay";
}

TEST_F(ShownTableTest, HeldCueBallIsShownWhereItIsHeld) {
    match_.hold_cue_ball({0, 0.2});
    shown_.refresh();
    EXPECT_EQ(shown_.balls()[0].r, (Vec2{end_game::kBaseLineX, 0.2}));
}

}  // namespace
}  // namespace poolhall::client
