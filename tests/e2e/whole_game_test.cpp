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
    duel.ann.request(Rematch{Seat{0}});
    const auto one_vote = [](const TableState& table) { return table.seats[0].wants_rematch; };
    EXPECT_EQ(duel.bob.await_table(one_vote).phase, Phase::kOver);
    duel.bob.request(Rematch{Seat{1}});
    const auto second = [](const TableState& table) { return table.game_number == 2; };
    const TableState table = spectator.await_table(second);
    EXPECT_EQ(table, duel.ann.await_table(second));
    EXPECT_EQ(table, duel.bob.await_table(second));
    duel.game = kEndGameRules.new_game(table.turn);
    EXPECT_EQ(table.scene, duel.game.scene);
    EXPECT_EQ(table.phase, Phase::kAiming);
    EXPECT_TRUE(table.may_place);
}

TEST_F(WholeGame, IsWonThenPlayedAgainWithTheSidesChangedAndLostByAScratch) {
    Duel duel(server.port());
    ProtocolClient watcher(server.port(), Encoding::kJson);
    const Joined watching = watcher.enter(WatchMatch{duel.ann_joined.table.code, "Wanda"});
    EXPECT_TRUE(watching.token.empty());
    EXPECT_TRUE(watching.seats.empty());
    EXPECT_EQ(watching.table.scene, duel.game.scene);
    const Seat first = duel.game.turn;

    expect_same_shot(watcher.hear_shot(), duel.play(Verdict::kTurnPasses));
    ASSERT_EQ(duel.game.turn, opponent(first));
    expect_same_shot(watcher.hear_shot(), duel.play(Verdict::kWon));
    EXPECT_EQ(duel.game.winner, opponent(first));

    rematch(duel, watcher);
    EXPECT_EQ(duel.game.turn, opponent(first));

    const ShotOutcome scratch = duel.play(Verdict::kScratch);
    const ShotHeard last = watcher.hear_shot();
    expect_same_shot(last, scratch);
    EXPECT_EQ(duel.game.winner, first);
    EXPECT_EQ(last.ended.table.game_number, 2U);
    EXPECT_EQ(last.ended.table.shot, 3U);
    EXPECT_EQ(last.ended.table.seats[0].wins, 1U);
    EXPECT_EQ(last.ended.table.seats[1].wins, 1U);
    EXPECT_EQ(last.ended.table.spectators, 1U);
}

TEST_F(WholeGame, ShowsTheCueBallPlacedAndTheAimAsItTurns) {
    Duel duel(server.port());
    ProtocolClient watcher(server.port(), Encoding::kCbor);
    watcher.enter(WatchMatch{duel.ann_joined.table.code, "Wanda"});
    const Seat seat = duel.game.turn;
    ProtocolClient& shooter = duel.player(seat);

    const Vec2 place{duel.game.scene.balls[0].state.r.x, 0.125};
    shooter.request(PlaceCueBall{seat, place});
    ASSERT_FALSE(kEndGameRules.place_cue_ball(duel.game, place));
    const auto at_place = [&](const AimChanged& aim) { return aim.cue == place; };
    EXPECT_EQ(watcher.await<AimChanged>(at_place).seat, seat);
    const Vec2 direction{0.75, -0.5};
    shooter.request(Aim{seat, direction});
    const auto turned = [&](const AimChanged& aim) { return aim.direction == direction; };
    EXPECT_EQ(watcher.await<AimChanged>(turned).cue, place);
    EXPECT_EQ(duel.player(opponent(seat)).await<AimChanged>(turned).cue, place);

    expect_same_shot(watcher.hear_shot(), duel.play(Verdict::kScratch));
}

TEST_F(WholeGame, IsPlayedByOnePersonFromBothSeats) {
    ProtocolClient alone(server.port(), Encoding::kJson);
    Joined joined = alone.enter(CreateMatch{"Ann"});
    EXPECT_EQ(joined.table.phase, Phase::kWaiting);
    alone.send(TakeSeat{Seat{1}});
    const auto seated = [](const TableState& table) { return table.phase == Phase::kAiming; };
    const TableState table = alone.await_table(seated);
    EXPECT_EQ(table.seats[1].name, "Ann");

    GameState game = kEndGameRules.new_game(table.turn);
    const ShotOutcome pass = find_shot(game, Verdict::kTurnPasses);
    alone.send(command_of(pass));
    expect_same_shot(alone.hear_shot(), pass);
    const ShotOutcome scratch = find_shot(pass.state, Verdict::kScratch);
    EXPECT_NE(scratch.ruling.shooter, pass.ruling.shooter);
    alone.send(command_of(scratch));
    expect_same_shot(alone.hear_shot(), scratch);
}

TEST_F(WholeGame, IsFollowedWithoutFramesByClientsThatSimulateForThemselves) {
    Duel duel(server.port());
    ProtocolClient watcher(server.port(), Encoding::kCbor);
    watcher.enter(WatchMatch{duel.ann_joined.table.code, "Wanda", Stream::kShots});

    const ShotOutcome outcome = duel.play(Verdict::kScratch);
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
