#include "shared/game/end_game.hpp"
#include "shared/physics/simulate.hpp"
#include "tests/e2e/server_process.hpp"
#include "tests/e2e/table.hpp"

#include <gtest/gtest.h>

// Whole games over the real server, each client judging what it hears by the shared simulation.
namespace poolhall::e2e {
namespace {

using namespace protocol;

class WholeGame : public testing::Test {
  protected:
    TemporaryFolder data;
    ServerProcess server{data.path()};
};

/// Both vote; everyone at the table hears of the new game.
void rematch(Duel& duel, ProtocolClient& spectator) {
    duel.ann.request(rematch_by(Seat{0}));
    const auto one_vote = [](const TableState& table) { return table.seats[0].wants_rematch; };
    EXPECT_EQ(duel.bob.await_table(one_vote).phase, Phase::kOver);
    duel.bob.request(rematch_by(Seat{1}));
    const auto second = [](const TableState& table) { return table.game_number == 2; };
    const TableState table = spectator.await_table(second);
    EXPECT_EQ(table, duel.ann.await_table(second));
    EXPECT_EQ(table, duel.bob.await_table(second));
    duel.game = kEndGameRules.new_game(table.state.turn);
    EXPECT_EQ(table.state, duel.game);
    EXPECT_EQ(table.legal, kEndGameRules.legal(duel.game));
    EXPECT_EQ(table.phase, Phase::kAiming);
}

TEST_F(WholeGame, IsWonThenPlayedAgainWithTheSidesChangedAndLostByAScratch) {
    Duel duel(server.port());
    ProtocolClient watcher(server.port(), Encoding::kJson);
    const Joined watching = watcher.enter(WatchMatch{duel.ann_joined.table.code, "Wanda"});
    EXPECT_TRUE(watching.token.empty());
    EXPECT_TRUE(watching.seats.empty());
    EXPECT_EQ(watching.table.state, duel.game);
    const Seat first = duel.game.turn;

    expect_same_shot(watcher.hear_shot(), duel.play(Verdict::kTurnPasses));
    ASSERT_EQ(duel.game.turn, opponent(first));
    expect_same_shot(watcher.hear_shot(), duel.play(Verdict::kWon));
    EXPECT_EQ(duel.game.winner, opponent(first));

    rematch(duel, watcher);
    EXPECT_EQ(duel.game.turn, opponent(first));

    const PlayedShot scratch = duel.play(Verdict::kScratch);
    const ShotHeard last = watcher.hear_shot();
    expect_same_shot(last, scratch);
    EXPECT_EQ(duel.game.winner, first);
    EXPECT_EQ(last.ended.table.game_number, 2U);
    EXPECT_EQ(last.ended.table.shot, 3U);
    EXPECT_EQ(last.ended.table.seats[0].wins, 1U);
    EXPECT_EQ(last.ended.table.seats[1].wins, 1U);
    EXPECT_EQ(last.ended.table.spectators, 1U);
}

TEST_F(WholeGame, ShowsTheCueBallHeldAndTheAimAsItTurnsAndPlacesTheBallOnce) {
    Duel duel(server.port());
    ProtocolClient watcher(server.port(), Encoding::kCbor);
    watcher.enter(WatchMatch{duel.ann_joined.table.code, "Wanda"});
    const Seat seat = duel.game.turn;
    ProtocolClient& shooter = duel.player(seat);
    ProtocolClient& other = duel.player(opponent(seat));

    const Vec2 place{end_game::kBaseLineX, 0.125};
    const Vec2 direction{0.75, -0.5};
    shooter.request(Aim{seat, direction, Vec2{0.3, place.y}});
    const auto held = [&](const AimChanged& aim) { return aim.cue == place; };
    EXPECT_EQ(watcher.await<AimChanged>(held).direction, direction) << "the nearest allowed place";
    EXPECT_EQ(other.await<AimChanged>(held).seat, seat);
    ProtocolClient late(server.port(), Encoding::kJson);
    const TableState before = late.enter(WatchMatch{duel.ann_joined.table.code, "Will"}).table;
    EXPECT_EQ(before.cue, place);
    EXPECT_EQ(before.state, duel.game) << "it is talk";

    shooter.request(MakeMove{seat, Place{place}});
    set_xy(duel.game.scene.balls[0].state.r, place);
    const auto placed = [&](const TableState& table) { return table.state == duel.game; };
    const TableState after = watcher.await_table(placed);
    EXPECT_EQ(after.legal, kEndGameRules.legal(duel.game));
    EXPECT_FALSE(after.cue);
    EXPECT_EQ(other.await_table(placed).aim, after.legal.aim);

    expect_same_shot(watcher.hear_shot(), duel.play(Verdict::kScratch));
}

TEST_F(WholeGame, IsGivenUpByTheSeatThatConcedesAndTheRaceIsWon) {
    MatchSettings settings;
    settings.race_to = 1;
    settings.breaks = BreakOrder::kLoser;
    Duel duel(server.port(), Encoding::kJson, Encoding::kCbor, settings);
    EXPECT_EQ(duel.bob_joined.table.settings, settings);
    const Seat loser = opponent(duel.game.turn);
    duel.player(loser).request(MakeMove{loser, Concede{}});
    const auto over = [](const TableState& table) { return table.phase == Phase::kOver; };
    const TableState table = duel.player(opponent(loser)).await_table(over);
    EXPECT_EQ(table.state, poolhall::concede(duel.game, loser).state);
    EXPECT_EQ(table.ruling.value().verdict, Verdict::kConceded);
    EXPECT_EQ(table.winner, opponent(loser));
    EXPECT_EQ(table.seats[opponent(loser).value].wins, 1U);

    duel.ann.request(rematch_by(Seat{0}));
    duel.bob.request(rematch_by(Seat{1}));
    const auto second = [](const TableState& next) { return next.game_number == 2; };
    const TableState next = duel.ann.await_table(second);
    EXPECT_EQ(next.state.turn, loser) << "the loser breaks";
    EXPECT_FALSE(next.winner);
    EXPECT_EQ(next.seats[opponent(loser).value].wins, 0U) << "a new race";
}

TEST_F(WholeGame, GoesOnWithTheOtherSeatWhenTheShotClockHasRunDown) {
    MatchSettings settings;
    settings.shot_clock_s = kMinShotClock;
    Duel duel(server.port(), Encoding::kJson, Encoding::kCbor, settings);
    ASSERT_TRUE(duel.bob_joined.table.clock_left_ms);
    EXPECT_LE(*duel.bob_joined.table.clock_left_ms, 1000 * kMinShotClock);
    const Seat slow = duel.game.turn;
    const auto passed = [&](const TableState& table) { return table.state.turn != slow; };
    const TableState table = duel.bob.await_table(passed);
    EXPECT_EQ(table.ruling.value().verdict, Verdict::kTimedOut);
    EXPECT_EQ(table.state.scene, duel.game.scene);
    EXPECT_EQ(duel.player(slow).refused(shot_by(slow, {1, 0})).code, RejectCode::kNotYourTurn);
    duel.game = table.state;
    duel.play(Verdict::kScratch);
}

TEST_F(WholeGame, IsPlayedByOnePersonFromBothSeats) {
    ProtocolClient alone(server.port(), Encoding::kJson);
    Joined joined = alone.enter(CreateMatch{"Ann"});
    EXPECT_EQ(joined.table.phase, Phase::kWaiting);
    alone.send(TakeSeat{Seat{1}});
    const auto seated = [](const TableState& table) { return table.phase == Phase::kAiming; };
    const TableState table = alone.await_table(seated);
    EXPECT_EQ(table.seats[1].name, "Ann");

    GameState game = kEndGameRules.new_game(table.state.turn);
    const PlayedShot pass = find_shot(game, Verdict::kTurnPasses);
    alone.send(command_of(pass));
    expect_same_shot(alone.hear_shot(), pass);
    const PlayedShot scratch = find_shot(pass.state, Verdict::kScratch);
    EXPECT_NE(scratch.ruling.shooter, pass.ruling.shooter);
    alone.send(command_of(scratch));
    expect_same_shot(alone.hear_shot(), scratch);
}

TEST_F(WholeGame, IsFollowedWithoutFramesByClientsThatSimulateForThemselves) {
    Duel duel(server.port());
    ProtocolClient watcher(server.port(), Encoding::kCbor);
    watcher.enter(WatchMatch{duel.ann_joined.table.code, "Wanda", Stream::kShots});

    const PlayedShot outcome = duel.play(Verdict::kScratch);
    const ShotHeard heard = watcher.hear_shot();
    EXPECT_TRUE(heard.frames.empty());
    const ShotTrace own = simulate(heard.started.scene);
    EXPECT_EQ(heard.started.final_hash, own.hash);
    EXPECT_EQ(heard.ended.hash, own.hash);
    EXPECT_EQ(heard.ended.balls, own.balls);
    EXPECT_EQ(heard.ended.ruling, outcome.ruling);
}

}  // namespace
}  // namespace poolhall::e2e
