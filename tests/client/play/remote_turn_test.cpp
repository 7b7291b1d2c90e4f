#include "tests/client/play/remote_fixture.hpp"

namespace poolhall::client {
namespace {

using namespace protocol;

/// Aiming, holding and shooting in a match on a server.
using RemoteTurnTest = RemoteMatchTest;

TEST_F(RemoteTurnTest, AimIsSentThirtyTimesASecondAndTheLastOneAlways) {
    open_as_anna();
    for (int frame = 1; frame <= 240; ++frame) {
        match_->aim({1, frame / 1000.0});
        pass(1.0 / 240);
    }
    EXPECT_LE(aims().size(), 31U);
    EXPECT_GE(aims().size(), 25U);
    EXPECT_LE(match_->due_in(now_), RemoteMatch::kAimEvery);
    pass(RemoteMatch::kAimEvery);
    EXPECT_EQ(aims().back().direction, (Vec2{1, 0.24}));
}

TEST_F(RemoteTurnTest, HeldCueBallShowsAtOnceAndAimsAtTheEightBall) {
    open_as_anna();
    const Vec2 place{end_game::kBaseLineX, 0.2};
    match_->hold_cue_ball({0.3, 0.2});
    EXPECT_EQ(cue(), place);
    EXPECT_NEAR(cross(match_->info().table->aim, Vec2{end_game::kFootSpotX, 0} - place), 0, 1e-12);
    // An older word about the table does not pull the ball back.
    transport_.say(TableChanged{new_table()});
    poll();
    EXPECT_EQ(cue(), place);
}

TEST_F(RemoteTurnTest, HeldCueBallIsShownToTheOthersAndNotPlaced) {
    open_as_anna();
    match_->hold_cue_ball({end_game::kBaseLineX, 0.1});
    match_->hold_cue_ball({end_game::kBaseLineX, 0.2});
    pass(1);
    ASSERT_EQ(aims().size(), 1U);
    EXPECT_EQ(aims()[0].cue, (Vec2{end_game::kBaseLineX, 0.2}));
    EXPECT_EQ(aims()[0].direction, match_->info().table->aim);
    EXPECT_TRUE(transport_.moves().empty());
}

TEST_F(RemoteTurnTest, HeldCueBallIsPlacedOnceRightBeforeTheShot) {
    open_as_anna();
    const Vec2 place{end_game::kBaseLineX, 0.2};
    match_->hold_cue_ball(place);
    shoot({1, 0});
    const Shoot shot{{.direction = {1, 0}}};
    EXPECT_EQ(transport_.moves(), (std::vector<Move>{Place{place}, shot}));
    EXPECT_LT(transport_.sent[0].seq, transport_.sent[1].seq);
    pass(1);
    EXPECT_TRUE(aims().empty()) << "the shot shows where it was aimed";
}

TEST_F(RemoteTurnTest, CueBallThatLiesWhereItIsHeldIsNotPlacedAgain) {
    open_as_anna();
    shoot({1, 0});
    EXPECT_EQ(transport_.moves().size(), 1U);
    transport_.sent.clear();
    match_->hold_cue_ball({end_game::kBaseLineX, 0.2});
    match_->hold_cue_ball({end_game::kBaseLineX, 0});
    shoot({1, 0});
    EXPECT_EQ(transport_.moves().size(), 1U);
}

TEST_F(RemoteTurnTest, CueBallThatIsNotInHandCannotBeHeld) {
    open_as_anna();
    TableState table = new_table();
    table.legal.place.reset();
    transport_.say(TableChanged{table});
    poll();
    const Vec2 before = cue();
    match_->hold_cue_ball({end_game::kBaseLineX, 0.2});
    EXPECT_EQ(cue(), before);
}

TEST_F(RemoteTurnTest, RefusedPlacementGoesBack) {
    open_as_anna();
    const Vec2 before = cue();
    match_->hold_cue_ball({end_game::kBaseLineX, 0.2});
    shoot({1, 0});
    transport_.say(Reject{transport_.sent.front().seq, RejectCode::kIllegal, "not there"});
    poll();
    EXPECT_EQ(cue(), before);
    EXPECT_EQ(match_->take_notice(), "not there");
}

TEST_F(RemoteTurnTest, AimIsShownAgainAfterARefusedShot) {
    open_as_anna();
    match_->aim({0, 1});
    shoot({0, 1});
    transport_.say(Reject{last_seq(), RejectCode::kStorage, "not stored"});
    poll();
    EXPECT_EQ(match_->take_notice(), "not stored");
    pass(1);
    ASSERT_EQ(aims().size(), 1U);
    EXPECT_EQ(aims()[0].direction, (Vec2{0, 1}));
}

TEST_F(RemoteTurnTest, RestartedServerIsToldOfTheAimAndTheHeldCueBall) {
    open_as_anna();
    match_->hold_cue_ball({end_game::kBaseLineX, 0.2});
    match_->aim({0, 1});
    pass(1);
    transport_.events.emplace_back(Lost{"gone", 0.3});
    transport_.events.emplace_back(Opened{});
    transport_.say(Welcome{"poolhall 0.1.0", kVersion});
    poll();
    joined({Seat{0}});
    pass(1);
    ASSERT_EQ(aims().size(), 1U);
    EXPECT_EQ(aims()[0].direction, (Vec2{0, 1}));
    EXPECT_EQ(aims()[0].cue, (Vec2{end_game::kBaseLineX, 0.2}));
}

TEST_F(RemoteTurnTest, ShotClockEndsByThisClientsClockAndNotWithoutAConnection) {
    open_as_anna();
    EXPECT_FALSE(match_->info().clock_ends);
    TableState table = new_table();
    table.clock_left_ms = 20'500;
    transport_.events.emplace_back(Received{{TableChanged{table}}, 99.5});
    poll();
    EXPECT_DOUBLE_EQ(match_->info().clock_ends.value(), 120);
    transport_.events.emplace_back(Lost{"gone", 0.3});
    poll();
    EXPECT_FALSE(match_->info().clock_ends);
}

TEST_F(RemoteTurnTest, LateAimIsNobodysMistake) {
    open_as_anna();
    match_->aim({0, 1});
    pass(1);
    transport_.say(Reject{transport_.sent.front().seq, RejectCode::kWrongPhase, "a shot runs"});
    poll();
    EXPECT_EQ(match_->take_notice(), "");
}

}  // namespace
}  // namespace poolhall::client
