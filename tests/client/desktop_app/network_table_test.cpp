#include "client/desktop/app/table_controller.hpp"
#include "client/play/remote_match.hpp"
#include "protocol/limits.hpp"
#include "tests/client/play/fixtures.hpp"

#include <gtest/gtest.h>

namespace poolhall::client {
namespace {

using namespace protocol;

/// What a player or spectator sees and can do in a match on a server.
class NetworkTableTest : public ::testing::Test {
  protected:
    void enter(std::vector<Seat> seats, const TableState& table = new_table()) {
        transport_.events.emplace_back(Opened{});
        transport_.say(Welcome{"poolhall 0.1.0", kVersion});
        run(1);
        transport_.say(Joined{1, seats.empty() ? "" : "t1", std::move(seats), table});
        run(1);
        transport_.sent.clear();
    }

    void run(int frames) {
        for (int frame = 0; frame < frames; ++frame) {
            now_ += 1.0 / 60;
            controller_.update(1.0 / 60, now_, {});
        }
    }

    void say_all(const std::vector<ServerMessage>& messages) {
        for (const auto& message : messages)
            transport_.say(message);
    }

    TokensInMemory tokens_;
    ScriptedTransport transport_;
    Playback playback_{Pacing::kLive};
    RemoteMatch match_{{"h:1", "", "Anna", false}, transport_, tokens_, playback_};
    TableController controller_{match_, playback_};
    double now_ = 10;
};

TEST_F(NetworkTableTest, WaitingForASecondPlayerShowsTheCode) {
    TableState table = new_table();
    table.phase = Phase::kWaiting;
    table.seats[1] = {};
    enter({Seat{0}}, table);
    EXPECT_NE(controller_.view().hint.find("BCD-FGH"), std::string::npos);
    EXPECT_EQ(controller_.view().match.code, "BCD-FGH");
    controller_.act(Action::kGo);
    EXPECT_EQ(transport_.shots(), 0U);
}

TEST_F(NetworkTableTest, OnlyTheOneWhoseTurnItIsShoots) {
    enter({Seat{1}});
    EXPECT_EQ(controller_.view().hint, "Anna is aiming");
    controller_.act(Action::kGo);
    EXPECT_EQ(transport_.shots(), 0U);
    transport_.say(TableChanged{table_with_turn(Seat{1})});
    run(1);
    controller_.act(Action::kGo);
    EXPECT_EQ(transport_.shots(), 1U);
}

TEST_F(NetworkTableTest, StepModeStepsThroughWhatWasReceivedAndSendsNothing) {
    enter({Seat{1}});
    controller_.act(Action::kStepMode);
    say_all(messages_of_shot(new_table(), kStraight));
    run(120);
    EXPECT_EQ(playback_.time(), 0);
    // The match has moved on; here it is still the first moment of the shot.
    EXPECT_EQ(match_.info().acting_seat(), Seat{1});
    EXPECT_EQ(controller_.view().match.turn, Seat{0});
    EXPECT_FALSE(controller_.view().aim);
    for (int step = 0; step < 10; ++step)
        controller_.act(Action::kGo);
    EXPECT_NEAR(playback_.time(), 10.0 / 30, 1e-12);
    EXPECT_EQ(transport_.shots(), 0U);
    for (int step = 0; step < 400 && !playback_.idle(); ++step)
        controller_.act(Action::kGo);
    run(1);
    EXPECT_FALSE(controller_.view().aim) << "the last step is still looked at";
    for (int press = 0; press < 10; ++press) {
        controller_.act(Action::kGo);
        run(20);
    }
    EXPECT_EQ(transport_.shots(), 0U);
    run(60);
    controller_.act(Action::kGo);
    EXPECT_TRUE(controller_.view().aim);
    run(60);
    controller_.act(Action::kGo);
    EXPECT_EQ(transport_.shots(), 1U);
}

TEST_F(NetworkTableTest, StepsThroughOnesOwnShotDoNotShootForTheOtherSeatOfAHotSeat) {
    enter({Seat{0}, Seat{1}});
    controller_.act(Action::kStepMode);
    say_all(messages_of_shot(new_table(), kStraight));
    run(120);
    for (int step = 0; step < 1000; ++step) {
        controller_.act(Action::kGo);
        run(6);
    }
    EXPECT_TRUE(playback_.idle());
    EXPECT_EQ(match_.info().acting_seat(), Seat{1});
    EXPECT_EQ(transport_.shots(), 0U);
}

TEST_F(NetworkTableTest, StepBeforeItsTickArrivesSaysSo) {
    enter({});
    controller_.act(Action::kStepMode);
    auto messages = messages_of_shot(new_table(), kStraight);
    messages.resize(2);
    say_all(messages);
    run(1);
    controller_.act(Action::kGo);
    controller_.act(Action::kGo);
    EXPECT_NE(controller_.view().status.find("not been received"), std::string::npos);
}

TEST_F(NetworkTableTest, LeavingStepModeCatchesUp) {
    enter({});
    controller_.act(Action::kStepMode);
    const auto messages = messages_of_shot(new_table(), kStraight);
    say_all(messages);
    run(10);
    controller_.act(Action::kStepMode);
    int frames = 0;
    for (; frames < 600 && !playback_.idle(); ++frames)
        run(1);
    const double real_time = std::get<ShotEnded>(messages.back()).duration;
    EXPECT_LT(frames / 60.0, real_time / 2);
}

TEST_F(NetworkTableTest, ResultIsSeenFromEachChair) {
    const auto messages = messages_of_shot(new_table(), direction_with(Verdict::kScratch));

    struct Chair {
        std::vector<Seat> seats;
        std::string title;
        Tone tone;
    };

    const std::vector<Chair> chairs = {{{Seat{0}}, "You lose", Tone::kLost},
                                       {{Seat{1}}, "You win", Tone::kWon},
                                       {{}, "Ben wins", Tone::kWon},
                                       {{Seat{0}, Seat{1}}, "Ben wins", Tone::kWon}};
    for (const Chair& chair : chairs) {
        playback_.clear();
        enter(chair.seats);
        say_all(messages);
        run(1200);
        ASSERT_TRUE(controller_.view().banner);
        EXPECT_EQ(controller_.view().banner->title, chair.title);
        EXPECT_EQ(controller_.view().banner->tone, chair.tone);
        EXPECT_TRUE(controller_.view().balls[0].sunk);
        EXPECT_EQ(controller_.view().match.seats[1].wins, 1U);
    }
}

TEST_F(NetworkTableTest, ScratchIsSaidWhileTheOtherBallStillRolls) {
    enter({Seat{1}});
    say_all(messages_of_shot(new_table(), direction_with(Verdict::kScratch, 0.5)));
    while (!controller_.view().balls[0].sunk && now_ < 60)
        run(1);
    ASSERT_FALSE(playback_.idle());
    EXPECT_EQ(controller_.view().hint, "Scratch: the cue ball is down");
}

TEST_F(NetworkTableTest, LostConnectionIsShownAndSpaceTriesAtOnce) {
    enter({Seat{0}});
    transport_.events.emplace_back(Lost{"No server listens there", 8});
    run(1);
    ASSERT_TRUE(controller_.view().banner);
    EXPECT_EQ(controller_.view().banner->title, "Connection lost");
    EXPECT_EQ(controller_.view().match.link, Link::kLost);
    controller_.act(Action::kGo);
    EXPECT_EQ(transport_.retries, 1);
    EXPECT_EQ(transport_.shots(), 0U);
}

}  // namespace
}  // namespace poolhall::client
