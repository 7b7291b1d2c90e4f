#include "tests/e2e/server_process.hpp"
#include "tests/e2e/table.hpp"

#include <gtest/gtest.h>
#include <optional>

// Connections and servers that end in the middle of things.
namespace poolhall::e2e {
namespace {

using namespace protocol;

Resume way_back(const Joined& joined) {
    return {joined.table.code, joined.token};
}

TEST(Recovery, ServerKilledInMidShotGoesOnFromItsResult) {
    const TemporaryFolder data;
    std::optional<ServerProcess> server(std::in_place, data.path());
    Duel duel(server->port());
    const PlayedShot outcome = find_shot(duel.game, Verdict::kTurnPasses);
    duel.player(duel.game.turn).send(command_of(outcome));
    duel.bob.await<Frame>([](const Frame& frame) { return frame.tick >= 5; });
    server->kill();
    server.emplace(data.path());

    duel.ann = ProtocolClient(server->port(), Encoding::kJson);
    const Joined ann = duel.ann.enter(way_back(duel.ann_joined));
    EXPECT_EQ(ann.seats, std::vector{Seat{0}});
    EXPECT_EQ(ann.table.match, duel.ann_joined.table.match);
    EXPECT_EQ(ann.table.shot, 1U);
    EXPECT_FALSE(ann.table.seats[1].connected);
    expect_table_after(ann.table, outcome);

    duel.bob = ProtocolClient(server->port(), Encoding::kCbor);
    const Joined bob = duel.bob.enter(way_back(duel.bob_joined));
    EXPECT_EQ(bob.seats, std::vector{Seat{1}});
    EXPECT_TRUE(bob.table.seats[0].connected);
    expect_table_after(bob.table, outcome);

    duel.game = outcome.state;
    duel.play(Verdict::kScratch);
    EXPECT_EQ(duel.game.winner, outcome.ruling.shooter);
}

TEST(Recovery, PlayerWhoseConnectionDropsComesBackToTheSeatWithTheToken) {
    const TemporaryFolder data;
    ServerProcess server(data.path());
    Duel duel(server.port());

    { const ProtocolClient dropped = std::move(duel.bob); }
    const auto gone = [](const TableState& table) { return !table.seats[1].connected; };
    const TableState without_bob = duel.ann.await_table(gone);
    EXPECT_TRUE(without_bob.seats[1].taken);
    EXPECT_EQ(without_bob.seats[1].name, "Bob");

    ProtocolClient stranger(server.port(), Encoding::kJson);
    const std::string code = duel.ann_joined.table.code;
    EXPECT_EQ(stranger.refused(JoinMatch{code, "Mallory"}).code, RejectCode::kMatchFull);
    EXPECT_EQ(stranger.refused(Resume{code, std::string(32, '0')}).code, RejectCode::kBadToken);

    duel.bob = ProtocolClient(server.port(), Encoding::kCbor);
    EXPECT_EQ(duel.bob.enter(way_back(duel.bob_joined)).seats, std::vector{Seat{1}});
    duel.ann.await_table([](const TableState& table) { return table.seats[1].connected; });
    duel.play(Verdict::kScratch);
}

TEST(Recovery, PlayerWhoComesBackInMidShotSeesItsEnd) {
    const TemporaryFolder data;
    ServerProcess server(data.path());
    Duel duel(server.port());
    const PlayedShot outcome = find_shot(duel.game, Verdict::kTurnPasses);
    duel.player(duel.game.turn).send(command_of(outcome));
    duel.bob.await<Frame>();
    { const ProtocolClient dropped = std::move(duel.bob); }

    duel.bob = ProtocolClient(server.port(), Encoding::kJson);
    const TableState table = duel.bob.enter(way_back(duel.bob_joined)).table;
    EXPECT_EQ(table.phase, Phase::kPlaying);
    EXPECT_TRUE(table.live.has_value());
    expect_table_after(duel.bob.await<ShotEnded>().table, outcome);
}

TEST(Recovery, NewerConnectionOfAPlayerReplacesTheOlder) {
    const TemporaryFolder data;
    ServerProcess server(data.path());
    Duel duel(server.port());
    ProtocolClient second(server.port(), Encoding::kJson);
    EXPECT_EQ(second.enter(way_back(duel.ann_joined)).seats, std::vector{Seat{0}});
    duel.ann.await<Closing>();
    EXPECT_EQ(duel.ann.socket().await_end(ProtocolClient::kPatience).code, 1008);
    EXPECT_EQ(second.refused(shot_by(Seat{1}, {1, 0})).code, RejectCode::kNotYourSeat);
}

TEST(Recovery, ServerAskedToEndInMidShotSaysSoAndKeepsTheShot) {
    const TemporaryFolder data;
    std::optional<ServerProcess> server(std::in_place, data.path());
    Duel duel(server->port());
    const PlayedShot outcome = find_shot(duel.game, Verdict::kTurnPasses);
    duel.player(duel.game.turn).send(command_of(outcome));
    duel.ann.await<Frame>();

    server->process().signal(SIGTERM);
    for (ProtocolClient* client : {&duel.ann, &duel.bob}) {
        EXPECT_FALSE(client->await<Closing>().reason.empty());
        EXPECT_EQ(client->socket().await_end(ProtocolClient::kPatience).code, 1001);
    }
    EXPECT_EQ(server->process().wait(), 0);

    server.emplace(data.path());
    duel.ann = ProtocolClient(server->port(), Encoding::kJson);
    expect_table_after(duel.ann.enter(way_back(duel.ann_joined)).table, outcome);
}

TEST(Recovery, FinishedMatchIsRebuiltWithItsWinsForTheRematch) {
    const TemporaryFolder data;
    std::optional<ServerProcess> server(std::in_place, data.path());
    Duel duel(server->port());
    const PlayedShot outcome = duel.play(Verdict::kScratch);
    server->kill();
    server.emplace(data.path());

    duel.ann = ProtocolClient(server->port(), Encoding::kJson);
    duel.bob = ProtocolClient(server->port(), Encoding::kCbor);
    const TableState table = duel.ann.enter(way_back(duel.ann_joined)).table;
    EXPECT_EQ(table.phase, Phase::kOver);
    EXPECT_EQ(table.seats[outcome.ruling.winner.value().value].wins, 1U);
    duel.bob.enter(way_back(duel.bob_joined));
    duel.ann.request(rematch_by(Seat{0}));
    duel.bob.request(rematch_by(Seat{1}));
    const auto second = [](const TableState& next) { return next.game_number == 2; };
    EXPECT_EQ(duel.ann.await_table(second).state.turn, opponent(outcome.ruling.shooter));
}

}  // namespace
}  // namespace poolhall::e2e
