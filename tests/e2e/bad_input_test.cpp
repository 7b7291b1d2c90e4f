#include "protocol/codec/codec.hpp"
#include "protocol/limits.hpp"
#include "tests/e2e/server_process.hpp"
#include "tests/e2e/table.hpp"

#include <gtest/gtest.h>
#include <string>
#include <vector>

// What no honest client sends. Whatever it is, the match at the next table, or at this one, goes on
// untouched.
namespace poolhall::e2e {
namespace {

using namespace protocol;

constexpr std::chrono::seconds kPatience = ProtocolClient::kPatience;

class BadInput : public testing::Test {
  protected:
    /// Sends a JSON text as it is and returns the reject that answers it.
    Reject answer(std::string_view text) {
        duel.ann.socket().send(text, true);
        return duel.ann.await<Reject>();
    }

    struct Case {
        std::string text;
        RejectCode code;
    };

    /// Fewer in a row than close the session.
    void expect_rejects(const std::vector<Case>& cases) {
        for (const Case& each : cases) {
            const Reject reject = answer(each.text);
            EXPECT_EQ(name(reject.code), name(each.code)) << each.text.substr(0, 80);
            EXPECT_FALSE(reject.reason.empty()) << each.text.substr(0, 80);
        }
    }

    /// The table is as it was, and the game can be played to its end.
    void TearDown() override {
        ProtocolClient watcher(server.port(), Encoding::kJson);
        const Joined joined = watcher.enter(WatchMatch{duel.ann_joined.table.code, "Wanda"});
        TableState before = duel.bob_joined.table;
        before.spectators = joined.table.spectators;
        before.seats = joined.table.seats;  // an offender may have lost the connection
        EXPECT_EQ(joined.table, before);
        EXPECT_EQ(server.process().status(), std::nullopt);
    }

    TemporaryFolder data;
    ServerProcess server{data.path()};
    Duel duel{server.port()};
};

TEST_F(BadInput, MessageThatIsNoneIsRejectedWithItsCode) {
    expect_rejects({
        {"{", RejectCode::kMalformed},
        {"", RejectCode::kMalformed},
        {"[1,2,3]", RejectCode::kMalformed},
        {R"({"type":"ping","seq":1} trailing)", RejectCode::kMalformed},
        {std::string(3000, '['), RejectCode::kMalformed},
        {R"({"type":"teleport","seq":900})", RejectCode::kUnknownType},
        {R"({"type":"shoot","seq":900,"seat":0})", RejectCode::kUnknownType},
        {R"({"type":"move","seq":900,"seat":0})", RejectCode::kMissingField},
        {R"({"type":"ping","seq":900,"extra":1})", RejectCode::kUnknownField},
        {R"({"type":"move","seq":900,"seat":2,"move":{"type":"concede"}})", RejectCode::kBadField},
        {R"({"type":"ping","seq":-1})", RejectCode::kBadField},
        {R"({"type":"ping","seq":1.5})", RejectCode::kBadField},
    });
}

TEST_F(BadInput, MoveThatIsNoneIsRejectedWithItsCode) {
    const auto move = [](const std::string& text) {
        return R"({"type":"move","seq":900,"seat":0,"move":)" + text + "}";
    };
    const auto shot = [&](const std::string& direction) {
        return move(R"({"type":"shoot","strike":{"direction":)" + direction + "}}");
    };
    expect_rejects({
        {move("null"), RejectCode::kBadField},
        {move("{}"), RejectCode::kMissingField},
        {move(R"({"type":"shoot"})"), RejectCode::kMissingField},
        {move(R"({"type":"dance"})"), RejectCode::kUnknownType},
        {move(R"({"type":"concede","why":1})"), RejectCode::kUnknownField},
        {move(R"({"type":"agree","what":"draw"})"), RejectCode::kBadField},
        {shot("[0,0]"), RejectCode::kBadField},
        {shot("[1e7,0]"), RejectCode::kBadField},
        {shot(R"(["1",0])"), RejectCode::kBadField},
        {shot("[1,0,0]"), RejectCode::kBadField},
        {shot("[1e999,0]"), RejectCode::kBadField},
        {shot("[NaN,0]"), RejectCode::kMalformed},
    });
}

TEST_F(BadInput, NotANumberInCborIsRejected) {
    // {"type": "aim", "seq": 900, "seat": 1, "direction": [NaN, Infinity]}
    const std::string bytes = std::string(
                                  "\xa4\x64type\x63"
                                  "aim\x63seq\x19\x03\x84\x64seat\x01\x69") +
                              std::string("direction\x82\xf9\x7e\x00\xf9\x7c\x00", 16);
    duel.bob.socket().send(bytes, false);
    const Reject reject = duel.bob.await<Reject>();
    EXPECT_EQ(reject.code, RejectCode::kBadField) << reject.reason;
    EXPECT_EQ(reject.seq, 900U);
    duel.bob.socket().send(std::string("\x9f\x9f\x9f", 3), false);
    EXPECT_EQ(duel.bob.await<Reject>().code, RejectCode::kMalformed);
}

TEST_F(BadInput, CommandThatTheMatchDoesNotAllowIsRejectedWithItsCode) {
    const Seat turn = duel.game.turn;
    ProtocolClient& shooter = duel.player(turn);
    ProtocolClient& other = duel.player(opponent(turn));
    EXPECT_EQ(other.refused(shot_by(opponent(turn), {1, 0})).code, RejectCode::kNotYourTurn);
    EXPECT_EQ(other.refused(shot_by(turn, {1, 0})).code, RejectCode::kNotYourSeat);
    EXPECT_EQ(other.refused(Aim{opponent(turn), {1, 0}}).code, RejectCode::kNotYourTurn);
    EXPECT_EQ(shooter.refused(MakeMove{turn, Place{{0.5, 0.5}}}).code, RejectCode::kIllegal);
    const MakeMove spun{turn, Shoot{Stroke{{1, 0}, {}, {0.5, 0}, 0}}};
    const Reject bounds = shooter.refused(spun);
    EXPECT_EQ(bounds.code, RejectCode::kIllegal);
    EXPECT_NE(bounds.reason.find("/move/strike/offset"), std::string::npos) << bounds.reason;
    EXPECT_EQ(shooter.refused(MakeMove{turn, TimeOut{}}).code, RejectCode::kIllegal);
    EXPECT_EQ(shooter.refused(rematch_by(turn)).code, RejectCode::kWrongPhase);
    EXPECT_EQ(shooter.refused(CreateMatch{"Ann"}).code, RejectCode::kAlreadyInMatch);
    const Reject stale = [&] {
        shooter.send_as(1, shot_by(turn, {1, 0}));
        return shooter.await<Reject>();
    }();
    EXPECT_EQ(stale.code, RejectCode::kStaleSeq);
    EXPECT_EQ(stale.seq, 1U);
}

TEST_F(BadInput, StrangerIsToldWhatIsWrong) {
    ProtocolClient stranger(server.port(), Encoding::kJson);
    const std::string code = duel.ann_joined.table.code;
    EXPECT_EQ(stranger.refused(shot_by(Seat{0}, {1, 0})).code, RejectCode::kNotInMatch);
    EXPECT_EQ(stranger.refused(JoinMatch{"BCDFGH", "Sam"}).code, RejectCode::kUnknownMatch);
    EXPECT_EQ(stranger.refused(JoinMatch{"aeiou1", "Sam"}).code, RejectCode::kBadField);
    EXPECT_EQ(stranger.refused(JoinMatch{code, std::string(33, 'x')}).code, RejectCode::kBadField);
    EXPECT_EQ(stranger.refused(JoinMatch{code, "Sam\x1b[2J"}).code, RejectCode::kBadField);
    EXPECT_EQ(stranger.refused(CreateMatch{"Sam", "snooker"}).code, RejectCode::kUnknownGame);
    EXPECT_EQ(stranger.refused(Resume{code, "short"}).code, RejectCode::kBadField);
    EXPECT_EQ(stranger.refused(Resume{code, std::string(32, 'f')}).code, RejectCode::kBadToken);
}

TEST_F(BadInput, ConnectionThatBreaksTheTransportIsClosedAsTheRfcAsks) {
    struct Offence {
        std::string what;
        std::uint16_t code;
        void (*offend)(WebSocket& socket);
    };

    const std::vector<Offence> cases{
        {"binary on JSON", 1003, [](WebSocket& socket) { socket.send("{}", false); }},
        {"not UTF-8", 1007, [](WebSocket& socket) { socket.send("\"\xff\xfe\"", true); }},
        {"oversized", 1009,
         [](WebSocket& socket) {
             socket.send(std::string(kMaxClientMessageBytes + 1, ' '), true);
         }},
        {"a reserved opcode", 1002,
         [](WebSocket& socket) { socket.send_raw(std::string("\x83\x80\0\0\0\0", 6)); }},
        {"an unmasked frame", 1002, [](WebSocket& socket) { socket.send_raw("\x81\x02{}"); }},
    };
    for (const Offence& each : cases) {
        ProtocolClient offender(server.port(), Encoding::kJson);
        each.offend(offender.socket());
        EXPECT_EQ(offender.socket().await_end(kPatience).code, each.code) << each.what;
    }
    ProtocolClient cbor(server.port(), Encoding::kCbor);
    cbor.socket().send("{}", true);
    EXPECT_EQ(cbor.socket().await_end(kPatience).code, 1003);
}

TEST_F(BadInput, ClientThatFloodsIsClosed) {
    ProtocolClient flood(server.port(), Encoding::kJson);
    std::string pings;
    for (int seq = 1; seq <= 1000; ++seq)
        flood.send(Ping{});
    EXPECT_EQ(flood.socket().await_end(kPatience).code, 1008);
}

TEST_F(BadInput, UnknownSubprotocolIsRefusedAtTheHandshake) {
    EXPECT_EQ(handshake_status(server.port(), "poolhall.v1.json"), 101);
    EXPECT_EQ(handshake_status(server.port(), ""), 101) << "JSON is the default";
    EXPECT_EQ(handshake_status(server.port(), "poolhall.v9.json"), 400);
}

TEST_F(BadInput, HttpPathThatLeadsNowhereIsAnsweredSo) {
    EXPECT_EQ(http_get(server.port(), "/api/replays/../../poolhall.sqlite").status, 400);
    EXPECT_EQ(http_get(server.port(), "/api/replays/..%2F..%2Fetc%2Fpasswd").status, 400);
    EXPECT_EQ(http_get(server.port(), "/api/replays/0123456789abcdef").status, 404);
    EXPECT_EQ(http_get(server.port(), "/api/replays?limit=0").status, 400);
    EXPECT_EQ(http_get(server.port(), "/../../etc/passwd").status, 404);
    EXPECT_EQ(http_get(server.port(), "/nothing").status, 404);
}

}  // namespace
}  // namespace poolhall::e2e
