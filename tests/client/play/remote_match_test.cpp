#include "client/play/remote_match.hpp"

#include "protocol/limits.hpp"
#include "tests/client/desktop_app/fixtures.hpp"

#include <gtest/gtest.h>
#include <memory>

namespace poolhall::client {
namespace {

using namespace protocol;

class RemoteMatchTest : public ::testing::Test {
  protected:
    void open(Wish wish) {
        match_ = std::make_unique<RemoteMatch>(std::move(wish), transport_, tokens_, playback_);
        transport_.events.emplace_back(Opened{});
        transport_.say(Welcome{"poolhall 0.1.0", kVersion});
        poll();
    }

    void open_as_anna() {
        open({"h:1", "", "Anna", false});
        joined({Seat{0}});
    }

    void joined(std::vector<Seat> seats, const TableState& table = new_table()) {
        transport_.say(Joined{last_seq(), seats.empty() ? "" : "t1", std::move(seats), table});
        poll();
        transport_.sent.clear();
    }

    void poll() { match_->poll(now_); }

    void pass(double seconds) {
        now_ += seconds;
        poll();
    }

    [[nodiscard]] std::uint32_t last_seq() const { return transport_.sent.back().seq; }

    template <class T>
    [[nodiscard]] std::vector<T> sent() const {
        std::vector<T> found;
        for (const auto& message : transport_.sent) {
            if (const auto* body = std::get_if<T>(&message.body)) found.push_back(*body);
        }
        return found;
    }

    [[nodiscard]] Vec2 cue() const { return xy(match_->info().table->scene.balls[0].state.r); }

    TemporaryFolder folder_;
    TokenStore tokens_{folder_.path};
    ScriptedTransport transport_;
    Playback playback_{Pacing::kLive};
    std::unique_ptr<RemoteMatch> match_;
    double now_ = 100;
};

TEST_F(RemoteMatchTest, WithoutACodeItMakesANewMatch) {
    open({"h:1", "", "Anna", false});
    ASSERT_EQ(sent<CreateMatch>().size(), 1U);
    EXPECT_EQ(sent<CreateMatch>()[0].name, "Anna");
    EXPECT_FALSE(sent<CreateMatch>()[0].settings);
    joined({Seat{0}});
    EXPECT_EQ(match_->info().link, Link::kOnline);
    EXPECT_EQ(match_->info().acting_seat(), Seat{0});
}

TEST_F(RemoteMatchTest, NewMatchGetsTheChosenPhysics) {
    GameSettings settings;
    settings.solver = SolverSpec{SolverKind::kEvent, 30};
    open({"h:1", "", "Anna", false, settings});
    ASSERT_EQ(sent<CreateMatch>().size(), 1U);
    EXPECT_EQ(sent<CreateMatch>()[0].settings, settings);
}

TEST_F(RemoteMatchTest, WithACodeItJoins) {
    open({"h:1", "BCDFGH", "Ben", false});
    ASSERT_EQ(sent<JoinMatch>().size(), 1U);
    EXPECT_EQ(sent<JoinMatch>()[0].code, "BCDFGH");
}

TEST_F(RemoteMatchTest, SpectatorMayDoNothing) {
    open({"h:1", "BCDFGH", "Cleo", true});
    ASSERT_EQ(sent<WatchMatch>().size(), 1U);
    joined({});
    match_->aim({0, 1});
    match_->shoot({0, 1});
    match_->toggle_hot_seat();
    pass(1);
    EXPECT_TRUE(sent<Aim>().empty() && sent<Shoot>().empty() && sent<TakeSeat>().empty());
}

TEST_F(RemoteMatchTest, TokenOfAnEarlierRunComesBackToTheSeat) {
    { TokenStore(folder_.path).keep("h:1", "BCDFGH", "old"); }
    open({"h:1", "BCDFGH", "Anna", false});
    ASSERT_EQ(sent<Resume>().size(), 1U);
    EXPECT_EQ(sent<Resume>()[0].token, "old");
}

TEST_F(RemoteMatchTest, OutdatedTokenIsForgottenAndTheMatchJoined) {
    { TokenStore(folder_.path).keep("h:1", "BCDFGH", "old"); }
    open({"h:1", "BCDFGH", "Anna", false});
    transport_.say(Reject{last_seq(), RejectCode::kBadToken, "no such token"});
    poll();
    EXPECT_EQ(sent<JoinMatch>().size(), 1U);
    EXPECT_EQ(tokens_.claim("h:1", "BCDFGH"), std::nullopt);
}

TEST_F(RemoteMatchTest, UnknownCodeIsSaid) {
    open({"h:1", "BCDFGH", "Ben", false});
    transport_.say(Reject{last_seq(), RejectCode::kUnknownMatch, "No match has this code"});
    poll();
    EXPECT_EQ(match_->info().trouble, "No match has this code");
    EXPECT_FALSE(match_->info().table);
}

TEST_F(RemoteMatchTest, FullServerIsTriedAgain) {
    open({"h:1", "", "Ben", false});
    transport_.say(Reject{last_seq(), RejectCode::kServerFull, "The hall is full"});
    poll();
    EXPECT_EQ(transport_.dropped, "The hall is full");
}

TEST_F(RemoteMatchTest, OtherProtocolVersionIsSaidAndNothingAsked) {
    match_ = std::make_unique<RemoteMatch>(Wish{"h:1", "", "Ben", false}, transport_, tokens_,
                                           playback_);
    transport_.events.emplace_back(Opened{});
    transport_.say(Welcome{"poolhall 9", 9});
    poll();
    EXPECT_TRUE(transport_.sent.empty());
    EXPECT_NE(match_->info().trouble.find("protocol 9"), std::string::npos);
}

TEST_F(RemoteMatchTest, LostConnectionIsResumedWithTheToken) {
    open_as_anna();
    transport_.events.emplace_back(Lost{"The server closed the connection", 0.3});
    poll();
    EXPECT_EQ(match_->info().link, Link::kLost);
    match_->shoot({1, 0});
    EXPECT_TRUE(transport_.sent.empty());
    transport_.events.emplace_back(Opened{});
    transport_.say(Welcome{"poolhall 0.1.0", kVersion});
    poll();
    ASSERT_EQ(sent<Resume>().size(), 1U);
    EXPECT_EQ(sent<Resume>()[0].token, "t1");
    EXPECT_EQ(sent<Resume>()[0].code, "BCDFGH");
    EXPECT_EQ(last_seq(), 1U);
}

TEST_F(RemoteMatchTest, MovesAreSentThirtyTimesASecondAndTheLastOneAlways) {
    open_as_anna();
    for (int frame = 1; frame <= 240; ++frame) {
        match_->aim({1, frame / 1000.0});
        pass(1.0 / 240);
    }
    EXPECT_LE(sent<Aim>().size(), 31U);
    EXPECT_GE(sent<Aim>().size(), 25U);
    EXPECT_LE(match_->due_in(now_), RemoteMatch::kMoveEvery);
    pass(RemoteMatch::kMoveEvery);
    EXPECT_EQ(sent<Aim>().back().direction, (Vec2{1, 0.24}));
}

TEST_F(RemoteMatchTest, PlacementShowsAtOnceAndAimsAtTheEightBall) {
    open_as_anna();
    const Vec2 place{end_game::kBaseLineX, 0.2};
    match_->place_cue_ball(place);
    EXPECT_EQ(cue(), place);
    EXPECT_NEAR(cross(match_->info().table->aim, Vec2{end_game::kFootSpotX, 0} - place), 0, 1e-12);
    pass(1);
    ASSERT_EQ(sent<PlaceCueBall>().size(), 1U);
    // An older word about the table does not pull the ball back while the answer is on its way.
    transport_.say(TableChanged{new_table()});
    poll();
    EXPECT_EQ(cue(), place);
}

TEST_F(RemoteMatchTest, RefusedPlacementGoesBack) {
    open_as_anna();
    const Vec2 before = cue();
    match_->place_cue_ball({end_game::kBaseLineX, 0.2});
    pass(1);
    transport_.say(Reject{transport_.sent.front().seq, RejectCode::kIllegal, "not there"});
    poll();
    EXPECT_EQ(cue(), before);
    EXPECT_EQ(match_->take_notice(), "not there");
}

TEST_F(RemoteMatchTest, PlacementGoesOutBeforeTheShot) {
    open_as_anna();
    match_->place_cue_ball({end_game::kBaseLineX, 0.2});
    match_->shoot({1, 0});
    ASSERT_EQ(transport_.sent.size(), 2U);
    EXPECT_TRUE(std::holds_alternative<PlaceCueBall>(transport_.sent[0].body));
    EXPECT_TRUE(std::holds_alternative<Shoot>(transport_.sent[1].body));
    EXPECT_LT(transport_.sent[0].seq, transport_.sent[1].seq);
}

TEST_F(RemoteMatchTest, LateAimIsNobodysMistake) {
    open_as_anna();
    match_->aim({0, 1});
    pass(1);
    transport_.say(Reject{transport_.sent.front().seq, RejectCode::kWrongPhase, "a shot runs"});
    poll();
    EXPECT_EQ(match_->take_notice(), "");
}

TEST_F(RemoteMatchTest, OpponentsAimAndCueBallAreShown) {
    open({"h:1", "BCDFGH", "Ben", false});
    joined({Seat{1}});
    transport_.say(AimChanged{Seat{0}, {0, 1}, {end_game::kBaseLineX, -0.1}});
    poll();
    EXPECT_EQ(match_->info().table->aim, (Vec2{0, 1}));
    EXPECT_EQ(cue().y, -0.1);
}

TEST_F(RemoteMatchTest, ShotIsPlayedAndEndsExactly) {
    open_as_anna();
    const auto messages = messages_of_shot(new_table(), kStraight);
    for (const auto& message : messages)
        transport_.say(message);
    poll();
    const auto& end = std::get<ShotEnded>(messages.back());
    double last_x = -10;
    for (int frame = 0; frame < 1200 && !playback_.idle(); ++frame) {
        last_x = playback_.shot()->timeline.position({0}, playback_.time()).x;
        playback_.advance(1.0 / 60);
    }
    EXPECT_TRUE(playback_.idle());
    EXPECT_GT(last_x, -10);
    bool finished = false;
    for (const auto& passed : playback_.take_passed()) {
        const auto* shot = std::get_if<Playback::ShotFinished>(&passed);
        if (shot == nullptr) continue;
        finished = true;
        EXPECT_EQ(shot->shot.timeline.position({0}, 1e9), xy(end.balls[0].state.r));
        EXPECT_EQ(shot->shot.timeline.position({1}, 1e9), xy(end.balls[1].state.r));
    }
    EXPECT_TRUE(finished);
    EXPECT_EQ(match_->info().table->turn, Seat{1});
}

TEST_F(RemoteMatchTest, LateComerSeesTheRestOfTheShot) {
    const auto messages = messages_of_shot(new_table(), kStraight);
    TableState table = new_table();
    table.phase = Phase::kPlaying;
    table.live = LiveShot{1, 40, {{0.1, 0.1}, {0.5, 0}}};
    open({"h:1", "BCDFGH", "Cleo", true});
    joined({}, table);
    ASSERT_FALSE(playback_.idle());
    EXPECT_EQ(playback_.shot()->timeline.position({0}, 0), (Vec2{0.1, 0.1}));
    for (std::size_t i = 41; i < messages.size(); ++i)
        transport_.say(messages[i]);
    poll();
    for (int frame = 0; frame < 1200 && !playback_.idle(); ++frame)
        playback_.advance(1.0 / 60);
    EXPECT_TRUE(playback_.idle());
}

TEST_F(RemoteMatchTest, ShotCutOffByALostConnectionIsNotWaitedFor) {
    open_as_anna();
    const auto messages = messages_of_shot(new_table(), kStraight);
    for (std::size_t i = 0; i < 20; ++i)
        transport_.say(messages[i]);
    transport_.events.emplace_back(Lost{"gone", 0.3});
    transport_.events.emplace_back(Opened{});
    transport_.say(Welcome{"poolhall 0.1.0", kVersion});
    poll();
    EXPECT_FALSE(playback_.idle());
    joined({Seat{0}}, std::get<ShotEnded>(messages.back()).table);
    EXPECT_TRUE(playback_.idle());
}

TEST_F(RemoteMatchTest, HotSeatIsTakenAndGivenBack) {
    open({"h:1", "", "Anna", false});
    TableState table = new_table();
    table.phase = Phase::kWaiting;
    table.seats[1] = {};
    joined({Seat{0}}, table);
    match_->toggle_hot_seat();
    ASSERT_EQ(sent<TakeSeat>().size(), 1U);
    transport_.say(Accepted{last_seq()});
    transport_.say(TableChanged{new_table()});
    poll();
    EXPECT_TRUE(match_->info().hot_seat());
    match_->toggle_hot_seat();
    ASSERT_EQ(sent<LeaveSeat>().size(), 1U);
    EXPECT_EQ(sent<LeaveSeat>()[0].seat, Seat{1});
    transport_.say(Accepted{last_seq()});
    poll();
    EXPECT_FALSE(match_->info().hot_seat());
}

TEST_F(RemoteMatchTest, RematchVotesForEverySeatHeld) {
    open({"h:1", "", "Anna", false});
    TableState table = new_table();
    table.phase = Phase::kOver;
    joined({Seat{0}, Seat{1}}, table);
    match_->ask_new_game();
    EXPECT_EQ(sent<Rematch>().size(), 2U);
}

TEST_F(RemoteMatchTest, RoundTripIsMeasuredByPing) {
    open_as_anna();
    pass(RemoteMatch::kPingEvery);
    ASSERT_FALSE(sent<Ping>().empty());
    transport_.say(Pong{last_seq()}, now_ + 0.042);
    poll();
    ASSERT_TRUE(match_->info().round_trip_ms);
    EXPECT_NEAR(*match_->info().round_trip_ms, 42, 1e-6);
}

TEST_F(RemoteMatchTest, ComingAndGoingIsToldToTheOthers) {
    open_as_anna();
    TableState table = new_table();
    table.seats[1].connected = false;
    transport_.say(TableChanged{table});
    poll();
    EXPECT_EQ(match_->take_notice(), "Ben has lost the connection");
    transport_.say(TableChanged{new_table()});
    poll();
    EXPECT_EQ(match_->take_notice(), "Ben is back");
}

TEST_F(RemoteMatchTest, NonsenseFromAServerIsSurvived) {
    open_as_anna();
    TableState table = new_table();
    table.cue_ball = BallIndex{9};
    transport_.say(TableChanged{table});
    transport_.say(Frame{7, 3, {{BallIndex{9}, {0, 0}}}, {}});
    transport_.say(AimChanged{Seat{9}, {0, 1}, {0, 0}});
    transport_.say(Accepted{99});
    auto messages = messages_of_shot(new_table(), kStraight);
    transport_.say(messages.front());
    auto end = std::get<ShotEnded>(messages.back());
    end.balls.pop_back();
    transport_.say(end);
    poll();
    EXPECT_EQ(match_->info().table->cue_ball, BallIndex{0});
    EXPECT_TRUE(playback_.idle());
}

}  // namespace
}  // namespace poolhall::client
