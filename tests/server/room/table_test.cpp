#include "server/room/table.hpp"

#include "shared/game/end_game.hpp"
#include "tests/server/support/seated_table.hpp"
#include "tests/shared/game/pool_settings.hpp"

#include <gtest/gtest.h>

namespace poolhall::server {
namespace {

using namespace test;
using protocol::Phase;

constexpr Vec2 kSafe{-1, 0.02};

TEST(Table, WaitsUntilBothSeatsAreTaken) {
    Table table = empty_table();
    EXPECT_EQ(phase_of(table), Phase::kWaiting);
    table.take_seat(Seat{0}, {"Ada", hash_token("a"), kAda});
    EXPECT_EQ(phase_of(table), Phase::kWaiting);
    table.take_seat(Seat{1}, {"Ben", hash_token("b"), kBen});
    EXPECT_EQ(phase_of(table), Phase::kAiming);
}

TEST(Table, StandsAsBeforeTheShotUntilItHasBeenShown) {
    Table table = seated_table();
    const GameState before = table.match.now().game;
    table.playout.emplace(shot_step(table, kSafe), std::chrono::microseconds(14));
    const protocol::TableState running = state_of(table, 0);
    EXPECT_EQ(running.phase, Phase::kPlaying);
    EXPECT_EQ(running.state, before);
    EXPECT_EQ(running.shot, 1U);
    EXPECT_TRUE(running.live.has_value());
    Playout shown = *std::exchange(table.playout, std::nullopt);
    const Ruling ruling = *shown.step().ruling();
    table.commit(std::move(shown).take_step(), 0);
    const protocol::TableState after = state_of(table, 0);
    EXPECT_EQ(after.phase, Phase::kAiming);
    EXPECT_EQ(after.legal.seat, Seat{1});
    EXPECT_EQ(after.shot, 1U);
    EXPECT_EQ(after.ruling, ruling);
    EXPECT_FALSE(after.live.has_value());
}

TEST(Table, AimTurnsToWhereTheRulesPointItAfterAMove) {
    Table table = seated_table();
    table.aim = {{0.1, 1}, Vec2{end_game::kBaseLineX, 0.3}};
    EXPECT_EQ(shown_cue_ball(table), (Vec2{end_game::kBaseLineX, 0.3}));
    const Vec2 place{end_game::kBaseLineX, 0.1};
    table.commit(table.match.play(Seat{0}, Place{place}, 0), 0);
    EXPECT_EQ(table.aim, (ShownAim{table.match.now().legal.aim, {}}));
    EXPECT_EQ(shown_cue_ball(table), place);
}

TEST(Table, EveryGameIsPlayedWithTheMatchsSettings) {
    MatchSettings settings;
    settings.game = poolhall::test::pool_settings();
    Table table = seated_table(settings);
    EXPECT_EQ(state_of(table, 0).settings, settings);
    EXPECT_EQ(state_of(table, 0).state.scene.effects, settings.game.effects);
    EXPECT_FALSE(state_of(seated_table(), 0).settings) << "its own, which need not be told";
}

TEST(Table, SeatThatChangesHandsBeginsWithoutWinsAndConsent) {
    Table table = seated_table();
    table.commit(table.match.play(Seat{1}, Concede{}, 0), 0);
    table.commit(table.match.play(Seat{0}, Agree{}, 0), 0);
    EXPECT_EQ(state_of(table, 0).seats[0].wins, 1U);
    EXPECT_TRUE(state_of(table, 0).seats[0].wants_rematch);
    table.leave_seat(Seat{0});
    table.take_seat(Seat{0}, {"Cy", hash_token("c"), MemberId{9}});
    EXPECT_EQ(state_of(table, 0).seats[0].wins, 0U);
    EXPECT_FALSE(state_of(table, 0).seats[0].wants_rematch);
}

TEST(Table, ClockRunsWhileSomebodyCanMove) {
    MatchSettings settings;
    settings.shot_clock_s = 30;
    Table table = seated_table(settings);
    EXPECT_TRUE(clock_runs(table));
    table.match.start_clock(1000);
    EXPECT_EQ(state_of(table, 11'000).clock_left_ms, 20'000U);
    EXPECT_EQ(state_of(table, 99'000).clock_left_ms, 0U);
    table.playout.emplace(shot_step(table, kSafe), std::chrono::microseconds(14));
    EXPECT_FALSE(clock_runs(table)) << "a shot runs";
    EXPECT_FALSE(state_of(table, 11'000).clock_left_ms);
    table.playout.reset();
    table.roster.disconnect(kAda);
    EXPECT_TRUE(clock_runs(table)) << "the other one waits";
    table.roster.disconnect(kBen);
    EXPECT_FALSE(clock_runs(table)) << "nobody is there";
    table.roster.resume(hash_token("b"), kBen);
    table.leave_seat(Seat{1});
    EXPECT_FALSE(clock_runs(table)) << "a seat is open";
    EXPECT_FALSE(clock_runs(seated_table())) << "no clock was agreed on";
}

}  // namespace
}  // namespace poolhall::server
