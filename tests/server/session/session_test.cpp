#include "tests/server/support/table.hpp"
#include "tests/shared/game/pool_settings.hpp"

namespace poolhall::server::test {
namespace {

using namespace protocol;

TEST(Session, SubprotocolIsNamedAndSpoken) {
    RunningServer server;
    Client json(server.json());
    EXPECT_EQ(json.subprotocol(), kSubprotocolJson);
    EXPECT_EQ(json.expect<Welcome>().protocol, kVersion);
    Client cbor(server.cbor());
    EXPECT_EQ(cbor.subprotocol(), kSubprotocolCbor);
    EXPECT_EQ(cbor.expect<Welcome>().protocol, kVersion);
    ConnectSpec none = server.json();
    none.subprotocol.reset();
    Client plain(none);
    EXPECT_EQ(plain.subprotocol(), "");
    EXPECT_EQ(plain.expect<Welcome>().protocol, kVersion);
}

TEST(Session, MessagesOfTheWrongKindCloseIt) {
    RunningServer server;
    Client json(server.json());
    json.send_raw("{}", false);
    EXPECT_EQ(json.wait_closed().code, 1003);
    Client cbor(server.cbor());
    cbor.send_raw("{}", true);
    EXPECT_EQ(cbor.wait_closed().code, 1003);
    Client text(server.json());
    text.send_raw("\xff\xfe", true);
    EXPECT_EQ(text.wait_closed().code, 1007);
    Client big(server.json());
    big.send_raw(std::string(kMaxClientMessageBytes + 1, ' '), true);
    EXPECT_EQ(big.wait_closed().code, 1009);
}

TEST(Session, TooManyMessagesCloseIt) {
    RunningServer server;
    Client client(server.json());
    for (int i = 0; i < 200; ++i)
        client.send(Ping{});
    EXPECT_NE(client.expect<Closing>().reason.find("60 a second"), std::string::npos);
    EXPECT_EQ(client.wait_closed().code, 1008);
}

TEST(Session, MalformedMessagesAreRejectedAndInTheEndCloseIt) {
    RunningServer server;
    Client client(server.json());
    for (int i = 0; i < 20; ++i) {
        client.send_raw("{", true);
        EXPECT_EQ(client.expect<Reject>().code, RejectCode::kMalformed);
    }
    EXPECT_EQ(client.wait_closed().code, 1008);
}

TEST(Session, BadCommandsAreRejectedAndTheMatchGoesOn) {
    RunningServer server;
    Table table(server);
    const TableState before = table.joined[1].table;
    Client& ada = table.players[0];
    const auto code = [&](const char* text) {
        ada.send_raw(text, true);
        return std::string(name(ada.expect<Reject>().code));
    };
    EXPECT_EQ(code("nonsense"), "malformed");
    EXPECT_EQ(code(R"({"type":"fly","seq":100})"), "unknown_type");
    EXPECT_EQ(code(R"({"type":"move","seq":101,"seat":0})"), "missing_field");
    EXPECT_EQ(code(R"({"type":"ping","seq":102,"x":1})"), "unknown_field");
    EXPECT_EQ(code(R"({"type":"aim","seq":103,"seat":0,"direction":[1e9,0]})"), "bad_field");
    EXPECT_EQ(code(R"({"type":"aim","seq":104,"seat":0,"direction":[0,0]})"), "bad_field");
    EXPECT_EQ(code(R"({"type":"ping","seq":1})"), "stale_seq");
    EXPECT_EQ(code(R"({"type":"move","seq":105,"seat":1,"move":{"type":"concede"}})"),
              "not_your_seat");
    EXPECT_EQ(code(R"({"type":"create_match","seq":106,"name":"x"})"), "already_in_match");
    EXPECT_EQ(
        code(R"({"type":"move","seq":107,"seat":0,"move":{"type":"agree","what":"rematch"}})"),
        "wrong_phase");
    EXPECT_EQ(code(R"({"type":"move","seq":108,"seat":0,"move":{"type":"time_out"}})"), "illegal");
    EXPECT_EQ(table.players[1].ask(shoot(Seat{1}, {1, 0}))->code, RejectCode::kNotYourTurn);

    Client stranger(server.json());
    EXPECT_EQ(stranger.ask(shoot(Seat{0}, {1, 0}))->code, RejectCode::kNotInMatch);
    EXPECT_EQ(stranger.ask(JoinMatch{"ZZZZZZ", "x"})->code, RejectCode::kUnknownMatch);
    EXPECT_EQ(stranger.ask(Resume{table.code(), std::string(32, '0')})->code,
              RejectCode::kBadToken);
    EXPECT_EQ(stranger.ask(JoinMatch{table.code(), "x"})->code, RejectCode::kMatchFull);
    EXPECT_EQ(stranger.ask(CreateMatch{"x", "snooker"})->code, RejectCode::kUnknownGame);
    stranger.send(WatchMatch{table.code(), ""});
    TableState after = stranger.expect<Joined>().table;
    after.spectators = before.spectators;
    EXPECT_EQ(after, before);

    ada.send_raw(R"({"type":"move","seq":200,"seat":0,)"
                 R"("move":{"type":"shoot","strike":{"direction":[-0.3875,0.3599]}}})",
                 true);
    EXPECT_EQ(ada.expect<Accepted>().seq, 200U);
    EXPECT_EQ(ada.expect<ShotEnded>().shot, 1U);
}

TEST(Session, UnfitSettingsBeginNoMatch) {
    RunningServer server;
    Client ada(server.json());
    const auto refusal = [&](const std::string& settings) {
        static int seq = 0;
        ada.send_raw(R"({"type":"create_match","name":"Ada","seq":)" + std::to_string(++seq) +
                         R"(,"settings":)" + settings + "}",
                     true);
        const Reject reject = ada.expect<Reject>();
        return std::string(name(reject.code)) + ": " + reject.reason;
    };
    const std::string bounds = " must be a finite number within its bounds";
    const std::pair<const char*, std::string> cases[]{
        {"7", "bad_field: field /settings must be an object"},
        {R"({"wind":{}})", "unknown_field: field /settings/wind is not known"},
        {R"({"effects":{"wind":{}}})", "unknown_field: field /settings/effects/wind is not known"},
        {R"({"effects":{"rolling":{"mu":-0.01}}})",
         "bad_field: field /settings/effects/rolling/mu" + bounds},
        {R"({"effects":{}})",
         "bad_field: field /settings/effects must bring the balls to rest: "
         "with linear_drag or rolling"},
        {R"({"solver":{"kind":"euler","hz":1e300}})",
         "bad_field: field /settings/solver/hz" + bounds},
        {R"({"solver":{"kind":"euler","hz":100000}})",
         "bad_field: field /settings/solver/hz must be at most 1000 in a game"},
        {R"({"solver":{"kind":"overlap"}})",
         "bad_field: field /settings/solver/kind must not be overlap in a game: it misses impacts"},
    };
    for (const auto& [settings, reason] : cases)
        EXPECT_EQ(refusal(settings), reason) << settings;
    EXPECT_EQ(http_get(server.address(), "/api/matches").body.find("end_game"), std::string::npos);

    Client ben(server.cbor());
    MatchSettings unfit;
    unfit.game.effects.emplace().sliding = SlidingSpec{};
    EXPECT_EQ(ben.ask(CreateMatch{"Ben", "end_game", {}, unfit})->code, RejectCode::kBadField);
    ben.send(CreateMatch{"Ben", "end_game", {}, MatchSettings{poolhall::test::pool_settings()}});
    EXPECT_EQ(ben.expect<Joined>().table.state.scene.solver.kind, SolverKind::kEvent);
}

TEST(Session, PlayerWhoDoesNotReadIsDroppedAndKeepsTheSeat) {
    RunningServer server;
    ConnectSpec slow = server.json();
    slow.receive_buffer = 2048;
    Client ben(slow);
    ben.send(CreateMatch{"Ben"});
    const Joined bens = ben.expect<Joined>();
    const auto is_connected = [&] {
        Client watcher(server.json());
        watcher.send(WatchMatch{bens.table.code, ""});
        return watcher.expect<Joined>().table.seats[0].connected;
    };
    // Ada comes and goes, which Ben never reads.
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    Client ada(server.json());
    while (is_connected() && std::chrono::steady_clock::now() < end) {
        for (int i = 0; i < 10; ++i) {
            ASSERT_FALSE(ada.ask(JoinMatch{bens.table.code, "Ada"}));
            ASSERT_FALSE(ada.ask(Leave{}));
            std::this_thread::sleep_for(std::chrono::milliseconds(35));
        }
    }
    EXPECT_FALSE(is_connected());
    Client again(server.json());
    again.send(Resume{bens.table.code, bens.token});
    EXPECT_EQ(again.expect<Joined>().seats, std::vector<Seat>{Seat{0}});
}

}  // namespace
}  // namespace poolhall::server::test
