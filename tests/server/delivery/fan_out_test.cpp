#include "tests/server/support/table.hpp"

namespace poolhall::server::test {
namespace {

using namespace protocol;

/// All of one shot as it came over the wire, from shot_started to shot_ended.
std::vector<std::string> read_shot(Client& client, Encoding encoding) {
    std::vector<std::string> shot;
    for (;;) {
        const auto raw = client.receive_raw();
        const auto& bytes = std::get<std::string>(raw);
        const auto message = decode_server(bytes, encoding);
        if (!message) throw std::runtime_error(message.error().reason);
        if (std::holds_alternative<ShotStarted>(*message)) shot.clear();
        shot.push_back(bytes);
        if (std::holds_alternative<ShotEnded>(*message)) return shot;
    }
}

TEST(FanOut, TwoHundredSpectatorsGetIdenticalBytes) {
    constexpr std::size_t kSpectators = 200;
    RunningServer server;
    Table table(server);
    std::vector<Client> spectators;
    for (std::size_t i = 0; i < kSpectators; ++i) {
        spectators.emplace_back(i % 2 == 0 ? server.json() : server.cbor());
        spectators.back().send(WatchMatch{table.code(), ""});
        spectators.back().expect<Joined>();
    }
    // The number of spectators is told a little later; then the table is quiet.
    std::this_thread::sleep_for(std::chrono::milliseconds(400));
    table.play(Seat{0}, kScratchDirection);
    const auto json = read_shot(spectators[0], Encoding::kJson);
    const auto cbor = read_shot(spectators[1], Encoding::kCbor);
    EXPECT_GT(json.size(), 5U);
    EXPECT_EQ(json.size(), cbor.size());
    for (std::size_t i = 2; i < kSpectators; ++i) {
        const bool is_json = i % 2 == 0;
        ASSERT_EQ(read_shot(spectators[i], is_json ? Encoding::kJson : Encoding::kCbor),
                  is_json ? json : cbor)
            << "spectator " << i;
    }
}

TEST(FanOut, StreamOfShotsHasTheHashAndNoFrames) {
    RunningServer server;
    Table table(server);
    Client spectator(server.cbor());
    spectator.send(WatchMatch{table.code(), "", Stream::kShots});
    spectator.expect<Joined>();
    const ShotEnded ended = table.play(Seat{0}, kScratchDirection);
    const ShotStarted started = spectator.expect<ShotStarted>();
    EXPECT_EQ(started.final_hash, ended.hash);
    EXPECT_TRUE(std::holds_alternative<ShotEnded>(spectator.receive())) << "no frame in between";
}

/// What a client saw of a shot.
struct Seen {
    std::size_t frames = 0;
    std::vector<double> events;  ///< their times
};

Seen watch_shot(Client& client) {
    Seen seen;
    for (;;) {
        const ServerMessage message = client.receive();
        if (const auto* frame = std::get_if<Frame>(&message)) {
            ++seen.frames;
            for (const ShotEvent& event : frame->events)
                seen.events.push_back(event.t);
        }
        if (std::holds_alternative<ShotEnded>(message)) return seen;
    }
}

TEST(FanOut, SpectatorWhoDoesNotReadHoldsNobodyUpAndMissesNoEvent) {
    RunningServer server;
    Client ada(server.json());
    ada.send(CreateMatch{"Ada"});
    const Joined joined = ada.expect<Joined>();
    ASSERT_FALSE(ada.ask(TakeSeat{Seat{1}}));
    ConnectSpec slow = server.json();
    slow.receive_buffer = 2048;
    Client spectator(slow);
    ASSERT_FALSE(spectator.ask(WatchMatch{joined.table.code, ""}));
    flood_table(ada);

    const auto start = std::chrono::steady_clock::now();
    ASSERT_FALSE(ada.ask(shoot(Seat{0}, {1, 0.02})));
    const Seen whole = watch_shot(ada);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    EXPECT_LT(took.count(), whole.events.back() + 1);
    // Now it reads, and finds every event of the shot in the few frames that were left of it.
    const Seen rest = watch_shot(spectator);
    EXPECT_LT(rest.frames, whole.frames / 4);
    EXPECT_EQ(rest.events, whole.events);
}

TEST(FanOut, LateSpectatorSeesTheRunningShot) {
    RunningServer server;
    Table table(server);
    ASSERT_FALSE(table.players[0].ask(shoot(Seat{0}, kSafeDirection)));
    table.players[0].expect<Frame>();
    Client spectator(server.json());
    spectator.send(WatchMatch{table.code(), ""});
    const Joined joined = spectator.expect<Joined>();
    EXPECT_EQ(joined.table.phase, Phase::kPlaying);
    ASSERT_TRUE(joined.table.live.has_value());
    const Frame frame = spectator.expect<Frame>();
    EXPECT_GT(frame.tick, joined.table.live->tick);
    EXPECT_EQ(spectator.expect<ShotEnded>().shot, 1U);
}

TEST(FanOut, AimIsShownToAllAndAtMostThirtyTimesASecond) {
    RunningServer server;
    Table table(server);
    for (int i = 1; i <= 40; ++i) {
        ASSERT_FALSE(table.players[0].ask(Aim{Seat{0}, {1, 0.01 * i}}));
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    int seen = 0;
    AimChanged aim;
    while (aim.direction.y < 0.4) {
        aim = table.players[1].expect<AimChanged>();
        ++seen;
    }
    EXPECT_EQ(aim.seat, Seat{0});
    EXPECT_LT(seen, 30) << "40 aims in 0.2 s or more are put together";
}

TEST(FanOut, TableAtRestSendsNothing) {
    RunningServer server;
    Table table(server);
    table.play(Seat{0}, kScratchDirection);
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    const auto sent = server.server().counters().messages_sent.load();
    EXPECT_FALSE(table.players[0].readable(std::chrono::milliseconds(700)));
    EXPECT_EQ(server.server().counters().messages_sent.load(), sent);
}

}  // namespace
}  // namespace poolhall::server::test
