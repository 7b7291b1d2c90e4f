#include "client/play/local_match.hpp"

#include "client/play/cue_ball.hpp"
#include "tests/client/play/fixtures.hpp"

#include <gtest/gtest.h>

namespace poolhall::client {
namespace {

using protocol::Phase;
using protocol::TableState;

/// Two people on one machine, or one alone.
class LocalMatchTest : public ::testing::Test {
  protected:
    explicit LocalMatchTest(const MatchSpec& spec = practice_spec(kEndGameRules))
        : match_(spec, {"Anna", "Ben"}, playback_) {}

    [[nodiscard]] const TableState& table() const { return *match_.info().table; }

    void shoot(Vec2 direction) { match_.make(Shoot{{.direction = direction}}); }

    Playback playback_{Pacing::kSteady};
    LocalMatch match_;
};

class HotSeatTest : public LocalMatchTest {
  protected:
    HotSeatTest() : LocalMatchTest({&kEndGameRules, Seat{0}, {}}) {}
};

class ShotClockTest : public LocalMatchTest {
  protected:
    ShotClockTest() : LocalMatchTest({&kEndGameRules, Seat{0}, {.game = {}, .shot_clock_s = 30}}) {}
};

TEST_F(LocalMatchTest, AloneEveryTurnIsTheOneSeats) {
    EXPECT_FALSE(match_.info().hot_seat());
    for (const Vec2 direction : {kStraight, Vec2{0, 1}}) {
        ASSERT_EQ(match_.info().acting_seat(), Seat{0});
        shoot(direction);
        ASSERT_EQ(table().phase, Phase::kAiming) << "the test wants a shot that goes on";
    }
    EXPECT_EQ(match_.info().acting_seat(), Seat{0});
    EXPECT_EQ(table().shot, 2U);
}

TEST_F(LocalMatchTest, ShotIsTheOneOfTheRulesAndIsPlayedBack) {
    const Turn turn = turn_of(table().state, {1, 0.03});
    shoot({1, 0.03});
    EXPECT_EQ(table().state.scene, turn.state.scene);
    EXPECT_EQ(table().ruling->verdict, turn.ruling->verdict);
    EXPECT_EQ(match_.info().kernel, turn.shot->trace.kernel);
    ASSERT_FALSE(playback_.idle());
    EXPECT_EQ(playback_.shot()->scene, turn.shot->scene);
    EXPECT_EQ(playback_.shot()->timeline.known_until(), turn.shot->trace.duration);
}

TEST_F(LocalMatchTest, ShotGoesFromWhereTheCueBallIsHeld) {
    const Vec2 place{end_game::kBaseLineX, 0.2};
    match_.hold_cue_ball(place);
    EXPECT_EQ(cue_ball_of(table()), place);
    EXPECT_NE(xy(table().state.scene.balls[0].state.r), place) << "held, not placed";
    shoot({0, 1});
    EXPECT_EQ(xy(playback_.shot()->scene.balls[0].state.r), place);
    EXPECT_FALSE(table().cue);
}

TEST_F(LocalMatchTest, IllegalMovesChangeNothing) {
    const TableState before = table();
    shoot({0, 0});
    match_.make(Agree{});
    match_.make(Place{{0.3, 0.3}});
    match_.make(TimeOut{});
    EXPECT_EQ(table(), before);
    EXPECT_TRUE(playback_.idle());
}

TEST_F(LocalMatchTest, NewGameComesByAgreementEvenWhileTheLastShotIsShown) {
    shoot(direction_with(Verdict::kScratch));
    ASSERT_EQ(table().phase, Phase::kOver);
    EXPECT_EQ(table().seats[1].wins, 1U);
    match_.make(Agree{});
    EXPECT_TRUE(playback_.idle());
    EXPECT_EQ(table().phase, Phase::kAiming);
    EXPECT_EQ(table().game_number, 2U);
    EXPECT_EQ(match_.info().acting_seat(), Seat{0});
}

TEST_F(LocalMatchTest, ThereIsNoSeatToShare) {
    match_.toggle_hot_seat();
    EXPECT_EQ(match_.take_notice(), "Practice has one seat only");
    EXPECT_EQ(match_.take_notice(), "");
}

TEST_F(HotSeatTest, TwoPeopleTakeTurnsOnOneMachine) {
    EXPECT_TRUE(match_.info().hot_seat());
    EXPECT_EQ(match_.info().acting_seat(), Seat{0});
    shoot(kStraight);
    EXPECT_EQ(match_.info().acting_seat(), Seat{1});
    shoot({0, 1});
    EXPECT_EQ(match_.info().acting_seat(), Seat{0});
}

TEST_F(HotSeatTest, RematchIsOneKeyForBothAndTheOtherBreaks) {
    shoot(direction_with(Verdict::kWon));
    ASSERT_EQ(table().phase, Phase::kOver);
    match_.make(Agree{});
    EXPECT_EQ(table().game_number, 2U);
    EXPECT_EQ(match_.info().acting_seat(), Seat{1});
}

TEST_F(HotSeatTest, WhoGivesUpInTurnLoses) {
    match_.make(Concede{});
    EXPECT_EQ(table().phase, Phase::kOver);
    EXPECT_EQ(table().ruling->winner, Seat{1});
}

TEST_F(ShotClockTest, TurnPassesWhenTheClockHasRunDownAfterTheShotWasShown) {
    match_.poll(0);
    EXPECT_DOUBLE_EQ(match_.due_in(10), 20);
    EXPECT_DOUBLE_EQ(match_.info().clock_ends.value(), 30);
    match_.poll(29.9);
    EXPECT_EQ(match_.info().acting_seat(), Seat{0});
    match_.poll(30);
    EXPECT_EQ(match_.info().acting_seat(), Seat{1});
    EXPECT_EQ(match_.take_notice(), "Anna's time is up: the turn passes");
    match_.poll(40);
    shoot({-1, 0.05});
    const double shown = playback_.shot()->timeline.known_until();
    EXPECT_NEAR(match_.due_in(40), 30 + shown, 2e-3);
}

}  // namespace
}  // namespace poolhall::client
