#include "tests/client/play/remote_fixture.hpp"

namespace poolhall::client {
namespace {

using namespace protocol;

TEST_F(RemoteMatchTest, WithoutACodeItMakesANewMatch) {
    open({"h:1", "", "Anna", false});
    ASSERT_EQ(entries<CreateMatch>().size(), 1U);
    EXPECT_EQ(entries<CreateMatch>()[0].name, "Anna");
    EXPECT_FALSE(entries<CreateMatch>()[0].settings);
    joined({Seat{0}});
    EXPECT_EQ(match_->info().link, Link::kOnline);
    EXPECT_EQ(match_->info().acting_seat(), Seat{0});
}

TEST_F(RemoteMatchTest, NewMatchGetsTheChosenPhysics) {
    MatchSettings settings;
    settings.game.solver = SolverSpec{SolverKind::kEvent, 30};
    open({"h:1", "", "Anna", false, settings});
    ASSERT_EQ(entries<CreateMatch>().size(), 1U);
    EXPECT_EQ(entries<CreateMatch>()[0].settings, settings);
}

TEST_F(RemoteMatchTest, WithACodeItJoins) {
    open({"h:1", "BCDFGH", "Ben", false});
    ASSERT_EQ(entries<JoinMatch>().size(), 1U);
    EXPECT_EQ(entries<JoinMatch>()[0].code, "BCDFGH");
}

TEST_F(RemoteMatchTest, SpectatorMayDoNothing) {
    open({"h:1", "BCDFGH", "Cleo", true});
    ASSERT_EQ(entries<WatchMatch>().size(), 1U);
    joined({});
    match_->aim({0, 1});
    shoot({0, 1});
    match_->toggle_hot_seat();
    pass(1);
    EXPECT_TRUE(aims().empty() && transport_.moves().empty());
    EXPECT_TRUE(seat_commands<TakeSeat>().empty());
}

TEST_F(RemoteMatchTest, TokenOfAnEarlierRunComesBackToTheSeat) {
    tokens_.keep("h:1", "BCDFGH", "old");
    open({"h:1", "BCDFGH", "Anna", false});
    ASSERT_EQ(entries<Resume>().size(), 1U);
    EXPECT_EQ(entries<Resume>()[0].token, "old");
}

TEST_F(RemoteMatchTest, OutdatedTokenIsForgottenAndTheMatchJoined) {
    tokens_.keep("h:1", "BCDFGH", "old");
    open({"h:1", "BCDFGH", "Anna", false});
    transport_.say(Reject{last_seq(), RejectCode::kBadToken, "no such token"});
    poll();
    EXPECT_EQ(entries<JoinMatch>().size(), 1U);
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
    match_ = std::make_unique<RemoteMatch>(EntryRequest{"h:1", "", "Ben", false}, transport_,
                                           tokens_, playback_);
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
    shoot({1, 0});
    EXPECT_TRUE(transport_.sent.empty());
    transport_.events.emplace_back(Opened{});
    transport_.say(Welcome{"poolhall 0.1.0", kVersion});
    poll();
    ASSERT_EQ(entries<Resume>().size(), 1U);
    EXPECT_EQ(entries<Resume>()[0].token, "t1");
    EXPECT_EQ(entries<Resume>()[0].code, "BCDFGH");
    EXPECT_EQ(last_seq(), 1U);
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
    EXPECT_EQ(match_->info().table->legal.seat, Seat{1});
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
    ASSERT_EQ(seat_commands<TakeSeat>().size(), 1U);
    transport_.say(Accepted{last_seq()});
    transport_.say(TableChanged{new_table()});
    poll();
    EXPECT_TRUE(match_->info().hot_seat());
    match_->toggle_hot_seat();
    ASSERT_EQ(seat_commands<LeaveSeat>().size(), 1U);
    EXPECT_EQ(seat_commands<LeaveSeat>()[0].seat, Seat{1});
    transport_.say(Accepted{last_seq()});
    poll();
    EXPECT_FALSE(match_->info().hot_seat());
}

TEST_F(RemoteMatchTest, RematchVotesForEverySeatHeld) {
    open({"h:1", "", "Anna", false});
    TableState table = new_table();
    table.phase = Phase::kOver;
    joined({Seat{0}, Seat{1}}, table);
    match_->make(Agree{});
    EXPECT_EQ(transport_.moves(), (std::vector<Move>{Agree{}, Agree{}}));
}

TEST_F(RemoteMatchTest, RematchIsAskedForOnce) {
    open({"h:1", "", "Anna", false});
    TableState table = new_table();
    table.phase = Phase::kOver;
    table.seats[0].wants_rematch = true;
    joined({Seat{0}}, table);
    match_->make(Agree{});
    EXPECT_TRUE(transport_.moves().empty());
}

TEST_F(RemoteMatchTest, GameIsGivenUpOutOfTurnToo) {
    open({"h:1", "BCDFGH", "Ben", false});
    joined({Seat{1}});
    match_->make(Concede{});
    const auto made = transport_.sent_of<MakeMove, TurnCommand>();
    ASSERT_EQ(made.size(), 1U);
    EXPECT_EQ(made[0], (MakeMove{Seat{1}, Concede{}}));
}

TEST_F(RemoteMatchTest, TurnThatTimedOutIsSaid) {
    open({"h:1", "BCDFGH", "Ben", false});
    joined({Seat{1}});
    TableState table = table_with_turn(Seat{1});
    table.ruling = Ruling{Verdict::kTimedOut, Seat{0}, Seat{1}, {}, 0};
    transport_.say(TableChanged{table});
    poll();
    EXPECT_EQ(match_->take_notice(), "Anna's time is up: the turn passes");
    transport_.say(TableChanged{table});
    poll();
    EXPECT_EQ(match_->take_notice(), "");
}

TEST_F(RemoteMatchTest, RoundTripIsMeasuredByPing) {
    open_as_anna();
    pass(RemoteMatch::kPingEvery);
    ASSERT_FALSE(transport_.sent.empty());
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
    table.state.cue_ball = BallIndex{9};
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
    EXPECT_EQ(match_->info().table->state.cue_ball, BallIndex{0});
    EXPECT_TRUE(playback_.idle());
}

}  // namespace
}  // namespace poolhall::client
