#include "shared/game/end_game.hpp"
#include "shared/physics/simulate.hpp"
#include "tests/e2e/server_process.hpp"
#include "tests/e2e/table.hpp"
#include "tests/shared/game/pool_settings.hpp"

#include <gtest/gtest.h>
#include <optional>

// Matches with effects and a solver of their own, over the real server.
namespace poolhall::e2e {
namespace {

using namespace protocol;
using poolhall::test::kPlayableSolvers;
using poolhall::test::pool_settings;

class Settings : public testing::Test {
  protected:
    Finished tool(const std::string& command, const std::string& id) {
        return run({POOLHALL_REPLAY, command, "--data", data.path(), id});
    }

    /// Expects that the stored match is what was played.
    void expect_replay(const std::string& id) {
        const Finished verified = tool("verify", id);
        EXPECT_EQ(verified.status, 0) << verified.out << verified.err;
        EXPECT_NE(verified.out.find("all as recorded"), std::string::npos) << verified.out;
    }

    TemporaryFolder data;
    std::optional<ServerProcess> server{std::in_place, data.path()};
};

/// Of a client in the stream `shots`: its own simulation gives what the server says.
void expect_own_simulation(const ShotHeard& heard, const PlayedShot& outcome) {
    EXPECT_TRUE(heard.frames.empty());
    const ShotTrace own = simulate(heard.started.scene);
    EXPECT_EQ(heard.started.final_hash, own.hash);
    EXPECT_EQ(own.hash, outcome.trace.hash);
    EXPECT_EQ(heard.ended.balls, own.balls);
    EXPECT_EQ(heard.ended.kernel, own.kernel);
}

TEST_F(Settings, MatchOfTheEventSolverIsPlayedToItsEndAndAgain) {
    Duel duel(server->port(), Encoding::kJson, Encoding::kCbor, {pool_settings()});
    const std::string code = duel.ann_joined.table.code;
    ProtocolClient wanda(server->port(), Encoding::kCbor);
    ProtocolClient will(server->port(), Encoding::kJson);
    EXPECT_EQ(wanda.enter(WatchMatch{code, "Wanda"}).table.state, duel.game);
    will.enter(WatchMatch{code, "Will", Stream::kShots});
    const auto play = [&](Verdict verdict) {
        const PlayedShot outcome = duel.play(verdict);
        expect_same_shot(wanda.hear_shot(), outcome);
        expect_own_simulation(will.hear_shot(), outcome);
    };
    play(Verdict::kTurnPasses);
    play(Verdict::kTurnPasses);
    play(Verdict::kWon);
    EXPECT_TRUE(duel.game.over);

    duel.ann.request(rematch_by(Seat{0}));
    duel.bob.request(rematch_by(Seat{1}));
    duel.game =
        new_game(kEndGameRules, opponent(duel.bob_joined.table.state.turn), pool_settings());
    play(Verdict::kScratch);
    const std::string id = duel.ann_joined.table.match;
    expect_replay(id);
    const Finished shown = tool("show", id);
    EXPECT_NE(shown.out.find("event         slide_roll_spin_end_game"), std::string::npos)
        << shown.out;
}

TEST_F(Settings, EverySolverIsShownAtThirtyHertzToTheLastBit) {
    for (const SolverSpec& solver : kPlayableSolvers) {
        SCOPED_TRACE(std::string(name(solver.kind)) + " " + std::to_string(solver.hz));
        Duel duel(server->port(), Encoding::kCbor, Encoding::kJson, {pool_settings(solver)});
        ProtocolClient will(server->port(), Encoding::kCbor);
        will.enter(WatchMatch{duel.ann_joined.table.code, "Will", Stream::kShots});
        const PlayedShot outcome = duel.play(Verdict::kTurnPasses);
        expect_own_simulation(will.hear_shot(), outcome);
        expect_replay(duel.ann_joined.table.match);
    }
}

TEST_F(Settings, SurviveAServerThatIsKilledInMidShot) {
    Duel duel(server->port(), Encoding::kJson, Encoding::kCbor, {pool_settings()});
    const PlayedShot outcome = find_shot(duel.game, Verdict::kTurnPasses);
    duel.player(duel.game.turn).send(command_of(outcome));
    duel.bob.await<Frame>([](const Frame& frame) { return frame.tick >= 5; });
    server->kill();
    server.emplace(data.path());

    const std::string code = duel.ann_joined.table.code;
    duel.ann = ProtocolClient(server->port(), Encoding::kCbor);
    duel.bob = ProtocolClient(server->port(), Encoding::kJson);
    expect_table_after(duel.ann.enter(Resume{code, duel.ann_joined.token}).table, outcome);
    expect_table_after(duel.bob.enter(Resume{code, duel.bob_joined.token}).table, outcome);
    duel.game = outcome.state;
    duel.play(Verdict::kScratch);
    duel.ann.request(rematch_by(Seat{0}));
    duel.bob.request(rematch_by(Seat{1}));
    const auto second = [](const TableState& table) { return table.game_number == 2; };
    const TableState table = duel.ann.await_table(second);
    EXPECT_EQ(table.state, new_game(kEndGameRules, table.state.turn, pool_settings()));
    expect_replay(duel.ann_joined.table.match);
}

TEST_F(Settings, OnesThatCannotBePlayedAreRefusedInBothEncodings) {
    for (const Encoding encoding : {Encoding::kJson, Encoding::kCbor}) {
        ProtocolClient client(server->port(), encoding);
        MatchSettings settings{pool_settings()};
        settings.game.effects->rolling.reset();
        const Reject unfit = client.refused(CreateMatch{"Ann", "end_game", {}, settings});
        EXPECT_EQ(unfit.code, RejectCode::kBadField);
        EXPECT_NE(unfit.reason.find("/settings/effects "), std::string::npos) << unfit.reason;
        settings = {pool_settings({SolverKind::kEuler, 1e6})};
        EXPECT_EQ(client.refused(CreateMatch{"Ann", "end_game", {}, settings}).code,
                  RejectCode::kBadField);
        settings = {{}, kMaxRace + 1};
        const Reject long_race = client.refused(CreateMatch{"Ann", "end_game", {}, settings});
        EXPECT_NE(long_race.reason.find("/settings/race_to "), std::string::npos)
            << long_race.reason;
        EXPECT_EQ(client.enter(CreateMatch{"Ann"}).table.state.scene,
                  kEndGameRules.new_game(Seat{0}).scene)
            << "the session goes on";
    }
}

}  // namespace
}  // namespace poolhall::e2e
