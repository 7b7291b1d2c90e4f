#include "tests/shared/match/matches.hpp"

#include <gtest/gtest.h>

namespace poolhall {
namespace {

using namespace test;

constexpr Seat kFirst{0};
constexpr Seat kSecond{1};
constexpr std::int64_t kTurn = 30'000;  // ms

Match timed_match() {
    MatchSettings settings;
    settings.shot_clock_s = 30;
    Match match(end_game_match(settings));
    match.start_clock(kNow);
    return match;
}

bool may_time_out(const Match& match, Seat seat, std::int64_t at_ms) {
    return !match.find_fault(seat, TimeOut{}, at_ms);
}

TEST(MatchClock, DoesNotRunWithoutASettingOrBeforeItIsStarted) {
    Match untimed(end_game_match());
    untimed.start_clock(kNow);
    EXPECT_FALSE(untimed.clock_ends_ms());
    MatchSettings settings;
    settings.shot_clock_s = 30;
    Match waiting(end_game_match(settings));
    EXPECT_FALSE(waiting.clock_ends_ms());
    for (Match* match : {&untimed, &waiting}) {
        const auto refusal = match->find_fault(kFirst, TimeOut{}, kNow * 1000);
        ASSERT_TRUE(refusal);
        EXPECT_EQ(MoveFault::kClockStillRuns, refusal->fault);
    }
}

TEST(MatchClock, RunsDownAfterItsSecondsAndNotBefore) {
    const Match match = timed_match();
    EXPECT_EQ(kNow + kTurn, match.clock_ends_ms());
    EXPECT_FALSE(may_time_out(match, kFirst, kNow + kTurn - 1));
    EXPECT_TRUE(may_time_out(match, kFirst, kNow + kTurn));
    const auto refusal = match.find_fault(kSecond, TimeOut{}, kNow + kTurn);
    ASSERT_TRUE(refusal) << "it is not the other seat's";
    EXPECT_EQ(MoveFault::kNotYourTurn, refusal->fault);
}

TEST(MatchClock, LeavesTheTurnToThePlayerUntilSomebodyEndsIt) {
    Match match = timed_match();
    EXPECT_FALSE(match.find_fault(kFirst, kPass, kNow + kTurn + 1));
    make(match, kFirst, TimeOut{}, kNow + kTurn);
    EXPECT_EQ(Verdict::kTimedOut, match.now().ruling.value().verdict);
    EXPECT_EQ(kSecond, match.now().legal.seat);
    EXPECT_EQ(kNow + 2 * kTurn, match.clock_ends_ms()) << "the next turn has its own time";
}

TEST(MatchClock, BeginsAnewWhenEverybodyHasSeenTheShot) {
    Match match = timed_match();
    const MatchStep step = match.play(kFirst, kPass, kNow + 1000);
    EXPECT_EQ(kNow + kTurn, match.clock_ends_ms()) << "playing changes nothing";
    match.commit(step, kNow + 7000);
    EXPECT_EQ(kNow + 7000 + kTurn, match.clock_ends_ms());
}

TEST(MatchClock, GivesNoMoreTimeForAPlacement) {
    Match match = timed_match();
    make(match, kFirst, Place{{end_game::kBaseLineX, 0.1}}, kNow + 20'000);
    EXPECT_EQ(kNow + kTurn, match.clock_ends_ms());
}

TEST(MatchClock, StandsStillWhileTheGameIsOver) {
    Match match = timed_match();
    make(match, kFirst, Concede{}, kNow + 1000);
    EXPECT_FALSE(match.clock_ends_ms());
    make(match, kFirst, Agree{}, kNow + 2000);
    EXPECT_FALSE(match.clock_ends_ms());
    make(match, kSecond, Agree{}, kNow + 900'000);
    EXPECT_EQ(kNow + 900'000 + kTurn, match.clock_ends_ms());
}

TEST(MatchClock, CanBeStartedAgainWhenAGameGoesOn) {
    Match match = timed_match();
    match.start_clock(kNow + 500'000);
    EXPECT_EQ(kNow + 500'000 + kTurn, match.clock_ends_ms());
}

TEST(MatchClock, RunsForTheOnlyPlayerToo) {
    MatchSettings settings;
    settings.shot_clock_s = 30;
    settings.turns = Turns::kSolo;
    Match match(end_game_match(settings));
    match.start_clock(kNow);
    make(match, kFirst, TimeOut{}, kNow + kTurn);
    EXPECT_EQ(kFirst, match.now().legal.seat);
    EXPECT_EQ(kNow + 2 * kTurn, match.clock_ends_ms());
}

}  // namespace
}  // namespace poolhall
