#include "tests/server/support/table.hpp"

#include <csignal>
#include <sys/resource.h>

// What people do at a table, and what must not be left behind when they go.
namespace poolhall::server::test {
namespace {

using namespace protocol;

TEST(Behaviour, PlayersTakeTurns) {
    RunningServer server;
    Table table(server);
    const ShotEnded ended = table.play(Seat{0});
    EXPECT_EQ(ended.table.legal.seat, Seat{1});
    EXPECT_EQ(table.players[0].ask(shoot(Seat{0}, kSafeDirection))->code, RejectCode::kNotYourTurn);
    EXPECT_FALSE(table.players[1].ask(shoot(Seat{1}, kSafeDirection)));
}

TEST(Behaviour, OnePersonCanPlayBothSeats) {
    RunningServer server;
    Client ada(server.json());
    ada.send(CreateMatch{"Ada"});
    const Joined joined = ada.expect<Joined>();
    ASSERT_FALSE(ada.ask(TakeSeat{Seat{1}}));
    ASSERT_FALSE(ada.ask(shoot(Seat{0}, kSafeDirection)));
    ada.expect<ShotEnded>();
    ASSERT_FALSE(ada.ask(shoot(Seat{1}, kSafeDirection)));
    ada.drop();
    Client again(server.json());
    again.send(Resume{joined.table.code, joined.token});
    EXPECT_EQ(again.expect<Joined>().seats.size(), 2U);
}

TEST(Behaviour, SpectatorWhoTakesASeatGetsAToken) {
    RunningServer server;
    Client ada(server.json());
    ada.send(CreateMatch{"Ada"});
    const Joined joined = ada.expect<Joined>();
    Client cy(server.json());
    cy.send(WatchMatch{joined.table.code, "Cy"});
    EXPECT_EQ(cy.expect<Joined>().token, "");
    cy.send(TakeSeat{Seat{1}});
    const Joined seated = cy.expect<Joined>();
    EXPECT_EQ(seated.token.size(), kTokenHexDigits);
    EXPECT_EQ(seated.seats, std::vector<Seat>{Seat{1}});
    EXPECT_EQ(seated.table.seats[1].name, "Cy");
    EXPECT_EQ(seated.table.spectators, 0U);
}

TEST(Behaviour, PlayerComesBackInMidShot) {
    RunningServer server;
    Table table(server);
    ASSERT_FALSE(table.players[0].ask(shoot(Seat{0}, kSafeDirection)));
    table.players[0].drop();
    Client again(server.json());
    again.send(Resume{table.code(), table.joined[0].token});
    const Joined joined = again.expect<Joined>();
    EXPECT_EQ(joined.seats, std::vector<Seat>{Seat{0}});
    EXPECT_EQ(joined.table.phase, Phase::kPlaying);
    EXPECT_EQ(again.expect<ShotEnded>().hash, table.players[1].expect<ShotEnded>().hash);
}

TEST(Behaviour, NewerConnectionReplacesTheOlder) {
    RunningServer server;
    Table table(server);
    Client newer(server.cbor());
    newer.send(Resume{table.code(), table.joined[0].token});
    EXPECT_EQ(newer.expect<Joined>().seats, std::vector<Seat>{Seat{0}});
    EXPECT_NE(table.players[0].expect<Closing>().reason.find("another connection"),
              std::string::npos);
    EXPECT_EQ(table.players[0].wait_closed().code, 1008);
    EXPECT_FALSE(newer.ask(shoot(Seat{0}, kSafeDirection)));
}

TEST(Behaviour, SeatThatIsLeftCanBeJoined) {
    RunningServer server;
    Table table(server);
    ASSERT_FALSE(table.players[1].ask(LeaveSeat{Seat{1}}));
    Client cy(server.json());
    cy.send(JoinMatch{table.code(), "Cy"});
    const Joined joined = cy.expect<Joined>();
    EXPECT_EQ(joined.seats, std::vector<Seat>{Seat{1}});
    EXPECT_EQ(joined.table.phase, Phase::kAiming);
    EXPECT_FALSE(table.players[0].ask(shoot(Seat{0}, kSafeDirection)));
}

TEST(Behaviour, RematchBeginsWhenBothWantIt) {
    RunningServer server;
    Table table(server);
    EXPECT_EQ(table.play(Seat{0}, kScratchDirection).ruling.verdict, Verdict::kScratch);
    ASSERT_FALSE(table.players[0].ask(MakeMove{Seat{0}, Agree{}}));
    EXPECT_TRUE(table.players[1].expect<TableChanged>().table.seats[0].wants_rematch);
    ASSERT_FALSE(table.players[1].ask(MakeMove{Seat{1}, Agree{}}));
    TableState begun = table.players[0].expect<TableChanged>().table;
    while (begun.phase == Phase::kOver)
        begun = table.players[0].expect<TableChanged>().table;
    EXPECT_EQ(begun.game_number, 2U);
    EXPECT_EQ(begun.legal.seat, Seat{1});
    EXPECT_EQ(begun.phase, Phase::kAiming);
}

TEST(Behaviour, MatchGoesOnAfterARestart) {
    RunningServer server;
    std::string code;
    std::array<std::string, 2> tokens;
    TableState before;
    {
        Table table(server);
        before = table.play(Seat{0}).table;
        code = table.code();
        tokens = {table.joined[0].token, table.joined[1].token};
    }
    server.restart();
    std::array<Client, 2> players{Client(server.json()), Client(server.cbor())};
    for (std::size_t i = 0; i < 2; ++i) {
        players[i].send(Resume{code, tokens[i]});
        const Joined joined = players[i].expect<Joined>();
        EXPECT_EQ(joined.seats, std::vector<Seat>{Seat{static_cast<std::uint8_t>(i)}});
        EXPECT_EQ(joined.table.state.scene, before.state.scene);
        EXPECT_EQ(joined.table.legal.seat, before.legal.seat);
    }
    EXPECT_FALSE(players[1].ask(shoot(Seat{1}, kSafeDirection)));
}

TEST(Behaviour, NothingIsLeftOfSessionsAndMatches) {
    ServerConfig config;
    config.idle_timeout = 1;
    RunningServer server(config);
    const Counters& counters = server.server().counters();
    for (int round = 0; round < 3; ++round) {
        Table table(server);
        Client spectator(server.json());
        spectator.send(WatchMatch{table.code(), ""});
        spectator.expect<Joined>();
        ASSERT_FALSE(table.players[0].ask(shoot(Seat{0}, kSafeDirection)));
        if (round == 0) table.players[0].drop();
        if (round == 1) table.players[0].close();
        // Round 2: all of them are dropped in mid-shot.
    }
    EXPECT_TRUE(eventually([&] { return counters.sessions.load() == 0; }));
    EXPECT_TRUE(eventually([&] { return counters.matches.load() == 0; }));
    EXPECT_TRUE(eventually([&] { return counters.connections.load() == 0; }));
}

TEST(Behaviour, MatchThatEverybodyLeavesIsClosedAtOnce) {
    RunningServer server;
    Table table(server);
    ASSERT_FALSE(table.players[0].ask(Leave{}));
    ASSERT_FALSE(table.players[1].ask(Leave{}));
    EXPECT_TRUE(eventually([&] { return server.server().counters().matches.load() == 0; }));
    EXPECT_EQ(table.players[0].ask(JoinMatch{table.code(), "Ada"})->code,
              RejectCode::kUnknownMatch);
    EXPECT_FALSE(table.players[0].ask(CreateMatch{"Ada"})) << "the session can go on";
}

TEST(Behaviour, LimitsOfMatchesAndSpectatorsHold) {
    ServerConfig config;
    config.max_matches = 1;
    config.max_spectators = 1;
    RunningServer server(config);
    Table table(server);
    Client first(server.json());
    EXPECT_EQ(first.ask(CreateMatch{"Cy"})->code, RejectCode::kServerFull);
    EXPECT_FALSE(first.ask(WatchMatch{table.code(), ""}));
    Client second(server.json());
    EXPECT_EQ(second.ask(WatchMatch{table.code(), ""})->code, RejectCode::kSpectatorsFull);
}

/// While it lives, no file of this process can grow, as on a full disk.
class FullDisk {
  public:
    FullDisk() {
        getrlimit(RLIMIT_FSIZE, &before_);
        rlimit full = before_;
        full.rlim_cur = 0;
        std::signal(SIGXFSZ, SIG_IGN);
        setrlimit(RLIMIT_FSIZE, &full);
    }

    ~FullDisk() { setrlimit(RLIMIT_FSIZE, &before_); }

    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

  private:
    rlimit before_{};
};

TEST(Behaviour, ShotThatCannotBeStoredIsNotPlayed) {
    RunningServer server;
    Table table(server);
    {
        const FullDisk full;
        EXPECT_EQ(table.players[0].ask(shoot(Seat{0}, kSafeDirection))->code, RejectCode::kStorage);
        Client other(server.json());
        EXPECT_EQ(other.ask(CreateMatch{"Cy"})->code, RejectCode::kStorage);
    }
    Client watcher(server.json());
    watcher.send(WatchMatch{table.code(), ""});
    TableState after = watcher.expect<Joined>().table;
    after.spectators = 0;
    EXPECT_EQ(after, table.joined[1].table);
    EXPECT_EQ(table.play(Seat{0}, kScratchDirection).shot, 1U);
    EXPECT_TRUE(eventually([&] { return server.server().counters().matches.load() == 1; }));
}

TEST(Behaviour, DrainTellsEverySessionWhy) {
    RunningServer server;
    Table table(server);
    ASSERT_FALSE(table.players[0].ask(shoot(Seat{0}, kSafeDirection)));
    std::thread drain([&] { server.server().drain(); });
    EXPECT_EQ(table.players[0].expect<Closing>().reason, "The server is shutting down.");
    EXPECT_EQ(table.players[0].wait_closed().code, 1001);
    EXPECT_EQ(table.players[1].wait_closed().code, 1001);
    drain.join();
    EXPECT_EQ(server.server().counters().sessions.load(), 0);
}

TEST(Behaviour, TakenPortIsNamed) {
    RunningServer server;
    TempFolder folder;
    ServerConfig config;
    config.listen = server.address();
    config.data = folder.str();
    const auto second = Server::start(config);
    ASSERT_FALSE(second.ok());
    EXPECT_EQ(second.error(), "cannot listen on " + server.address() + ": Address already in use");
}

TEST(Behaviour, FolderOfARunningServerIsRefused) {
    RunningServer server;
    ServerConfig config;
    config.listen = "127.0.0.1:0";
    config.data = server.data().string();
    const auto second = Server::start(config);
    ASSERT_FALSE(second.ok());
    EXPECT_NE(second.error().find(server.data().string()), std::string::npos) << second.error();
}

}  // namespace
}  // namespace poolhall::server::test
