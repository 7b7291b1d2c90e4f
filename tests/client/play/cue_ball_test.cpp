#include "client/play/cue_ball.hpp"

#include "tests/client/play/fixtures.hpp"

#include <gtest/gtest.h>

namespace poolhall::client {
namespace {

constexpr Vec2 kHeld{end_game::kBaseLineX, 0.2};

TEST(CueBall, IsShownWhereItIsHeldAndElseWhereItLies) {
    protocol::TableState table = new_table();
    EXPECT_EQ(cue_ball_of(table), (Vec2{end_game::kBaseLineX, 0}));
    table.cue = kHeld;
    EXPECT_EQ(cue_ball_of(table), kHeld);
    EXPECT_EQ(xy(shown_state(table).scene.balls[0].state.r), kHeld);
}

TEST(CueBall, IsHeldAtTheNearestPlaceOfTheRegionWhateverItsShape) {
    protocol::TableState table = new_table();
    EXPECT_TRUE(hold_cue_ball(table, {0.5, 0.2}));
    EXPECT_EQ(cue_ball_of(table), kHeld);
    table.legal.place = Region{{-0.7, -0.3}, {-0.2, 0.3}};
    EXPECT_TRUE(hold_cue_ball(table, {-0.3, 0.1}));
    EXPECT_EQ(cue_ball_of(table), (Vec2{-0.3, 0.1}));
    EXPECT_TRUE(hold_cue_ball(table, {0.5, 0.9}));
    EXPECT_EQ(cue_ball_of(table), (Vec2{-0.2, 0.3}));
}

TEST(CueBall, StaysWhereItIsNotInHand) {
    protocol::TableState table = new_table();
    table.legal.place.reset();
    EXPECT_FALSE(hold_cue_ball(table, kHeld));
    EXPECT_FALSE(table.cue);
}

TEST(CueBall, MovingItPointsTheAimAnewAndStandingStillDoesNot) {
    protocol::TableState table = new_table();
    ASSERT_TRUE(hold_cue_ball(table, kHeld));
    EXPECT_EQ(table.aim, (Vec2{end_game::kFootSpotX, 0} - kHeld));
    table.aim = {0, 1};
    EXPECT_FALSE(hold_cue_ball(table, kHeld));
    EXPECT_EQ(table.aim, (Vec2{0, 1}));
}

TEST(CueBall, GameThatIsNotKnownHereLeavesTheAim) {
    protocol::TableState table = new_table();
    table.game = "bar_billiards";
    table.aim = {0, 1};
    EXPECT_TRUE(hold_cue_ball(table, kHeld));
    EXPECT_EQ(table.aim, (Vec2{0, 1}));
}

TEST(CueBall, IsUnplacedOnlyAwayFromWhereItLies) {
    protocol::TableState table = new_table();
    EXPECT_EQ(unplaced_cue_ball(table), std::nullopt);
    table.cue = cue_ball_of(table);
    EXPECT_EQ(unplaced_cue_ball(table), std::nullopt);
    table.cue = kHeld;
    EXPECT_EQ(unplaced_cue_ball(table), kHeld);
}

}  // namespace
}  // namespace poolhall::client
