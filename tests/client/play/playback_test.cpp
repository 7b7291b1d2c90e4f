#include "client/play/playback.hpp"

#include <array>
#include <gtest/gtest.h>

namespace poolhall::client {
namespace {

constexpr double kTick = Playback::kStep;
constexpr BallIndex kCue{0};

/// One ball that runs 1 m/s along x.
Shot running_shot(std::uint32_t number = 1) {
    Shot shot{number, {}, kCue, ShotTimeline(std::array{Vec2{0, 0}}), std::nullopt};
    shot.scene.balls = {{"cue", {}}};
    return shot;
}

void receive_tick(Playback& playback, int tick) {
    playback.newest()->timeline.extend(tick * kTick, {},
                                       std::array{ShotTimeline::Moved{kCue, {tick * kTick, 0}}});
}

void receive_end(Playback& playback, double duration) {
    FinalBall ball;
    ball.state.r.x = duration;
    playback.newest()->timeline.finish(duration, std::array{ball});
}

double x(const Playback& playback) {
    return playback.shot()->timeline.position(kCue, playback.time()).x;
}

int count_ends(Playback& playback) {
    int ends = 0;
    for (const auto& passed : playback.take_passed()) {
        if (std::holds_alternative<Playback::ShotFinished>(passed)) ++ends;
    }
    return ends;
}

TEST(Playback, SteadyPlaysInRealTimeFromTheFirstMoment) {
    Playback playback(Pacing::kSteady);
    playback.begin(running_shot());
    receive_end(playback, 1);
    playback.advance(0.25);
    EXPECT_DOUBLE_EQ(playback.time(), 0.25);
    EXPECT_DOUBLE_EQ(x(playback), 0.25);
    playback.advance(5);
    EXPECT_TRUE(playback.idle());
    EXPECT_EQ(count_ends(playback), 1);
}

TEST(Playback, LiveWaitsForTwoTicksBeforeItStarts) {
    Playback playback(Pacing::kLive);
    playback.begin(running_shot());
    receive_tick(playback, 1);
    playback.advance(0.01);
    EXPECT_EQ(playback.time(), 0);
    receive_tick(playback, 2);
    playback.advance(0.01);
    EXPECT_GT(playback.time(), 0);
}

TEST(Playback, LiveNeverShowsWhatWasNotReceived) {
    Playback playback(Pacing::kLive);
    playback.begin(running_shot());
    for (int tick = 1; tick <= 3; ++tick)
        receive_tick(playback, tick);
    for (int frame = 0; frame < 60; ++frame)
        playback.advance(1.0 / 60);
    EXPECT_DOUBLE_EQ(playback.time(), 3 * kTick);
    EXPECT_DOUBLE_EQ(x(playback), 3 * kTick);
}

TEST(Playback, LiveStaysAboutTwoTicksBehindWhateverTheFrameRate) {
    for (const int frames_per_tick : {1, 2, 5}) {
        Playback playback(Pacing::kLive);
        playback.begin(running_shot());
        double last = 0;
        for (int tick = 1; tick <= 90; ++tick) {
            receive_tick(playback, tick);
            for (int frame = 0; frame < frames_per_tick; ++frame) {
                playback.advance(kTick / frames_per_tick);
                EXPECT_GE(playback.time(), last);
                last = playback.time();
            }
        }
        const double behind = 90 * kTick - playback.time();
        EXPECT_GT(behind, 0.5 * kTick) << frames_per_tick;
        EXPECT_LT(behind, 3 * kTick) << frames_per_tick;
    }
}

TEST(Playback, UnsteadyArrivalIsShownWithoutStandingStill) {
    Playback playback(Pacing::kLive);
    playback.begin(running_shot());
    int stalls = 0;
    int received = 0;
    for (int frame = 1; frame <= 600; ++frame) {
        // Every other tick comes a tick and a half late.
        const double now = frame / 60.0;
        while ((received + 1) * kTick + (received % 2 == 0 ? 1.5 * kTick : 0) <= now)
            receive_tick(playback, ++received);
        const double before = playback.time();
        playback.advance(1.0 / 60);
        if (frame > 200 && playback.time() == before) ++stalls;
    }
    EXPECT_EQ(stalls, 0);
}

TEST(Playback, CatchesUpAfterStandingStill) {
    Playback playback(Pacing::kLive);
    playback.begin(running_shot());
    for (int tick = 1; tick <= 150; ++tick)
        receive_tick(playback, tick);
    int frames = 0;
    while (150 * kTick - playback.time() > 4 * kTick && frames < 600) {
        playback.advance(1.0 / 60);
        ++frames;
    }
    EXPECT_LT(frames, 180);
}

TEST(Playback, StepIsExactlyOneThirtieth) {
    Playback playback(Pacing::kSteady);
    playback.begin(running_shot());
    receive_end(playback, 1);
    ASSERT_TRUE(playback.step());
    EXPECT_EQ(playback.time(), kTick);
    ASSERT_TRUE(playback.step());
    EXPECT_EQ(playback.time(), kTick + kTick);
    for (int step = 2; step < 30; ++step)
        playback.step();
    EXPECT_TRUE(playback.idle());
}

TEST(Playback, StepBeyondWhatWasReceivedIsRefused) {
    Playback playback(Pacing::kLive);
    EXPECT_FALSE(playback.step());
    playback.begin(running_shot());
    EXPECT_FALSE(playback.step());
    receive_tick(playback, 1);
    EXPECT_TRUE(playback.step());
    EXPECT_FALSE(playback.step());
    EXPECT_EQ(playback.time(), kTick);
}

TEST(Playback, StepsLeadThroughShotsThatCameMeanwhile) {
    Playback playback(Pacing::kLive);
    for (const std::uint32_t number : {1U, 2U}) {
        playback.begin(running_shot(number));
        receive_tick(playback, 1);
        receive_end(playback, 1.5 * kTick);
    }
    playback.step();
    playback.step();
    ASSERT_FALSE(playback.idle());
    EXPECT_EQ(playback.shot()->number, 2U);
    EXPECT_EQ(playback.time(), 0);
    playback.step();
    playback.step();
    EXPECT_TRUE(playback.idle());
}

TEST(Playback, ShotsThatWaitAreBounded) {
    Playback playback(Pacing::kLive);
    for (std::uint32_t number = 1; number <= 100; ++number) {
        playback.begin(running_shot(number));
        receive_end(playback, 1);
    }
    EXPECT_GT(playback.shot()->number, 80U);
}

TEST(Playback, EventsArePassedOnceAndInOrder) {
    Playback playback(Pacing::kSteady);
    playback.begin(running_shot());
    std::array<ShotEvent, 2> events;
    events[0].kind = EventKind::kStrike;
    events[1].kind = EventKind::kBallRail;
    events[1].t = 0.5 * kTick;
    playback.newest()->timeline.extend(kTick, events, {});
    receive_end(playback, kTick);
    playback.advance(0.25 * kTick);
    auto passed = playback.take_passed();
    ASSERT_EQ(passed.size(), 2U);
    EXPECT_TRUE(std::holds_alternative<Playback::ShotBegan>(passed[0]));
    EXPECT_EQ(std::get<ShotEvent>(passed[1]).kind, EventKind::kStrike);
    playback.advance(0.5 * kTick);
    passed = playback.take_passed();
    ASSERT_EQ(passed.size(), 1U);
    EXPECT_EQ(std::get<ShotEvent>(passed[0]).kind, EventKind::kBallRail);
}

/// A shot of 1 s with an event at each quarter.
void play_with_events(Playback& playback) {
    playback.begin(running_shot());
    std::array<ShotEvent, 5> events;
    for (std::size_t i = 0; i < events.size(); ++i) {
        events[i].kind = i == 0 ? EventKind::kStrike : EventKind::kBallRail;
        events[i].t = 0.25 * static_cast<double>(i);
        set_xy(events[i].after[0].r, {events[i].t, 0});
    }
    playback.newest()->timeline.extend(1, events, {});
    receive_end(playback, 1);
    (void)playback.take_passed();
}

TEST(Playback, AnyTimeOfTheShotCanBeSoughtInAnyOrder) {
    Playback playback(Pacing::kSteady);
    play_with_events(playback);
    for (const double t : {0.6, 0.1, 0.99, 0.5, 0.0}) {
        playback.seek(t);
        EXPECT_EQ(playback.time(), t);
        EXPECT_DOUBLE_EQ(x(playback), t);
    }
}

TEST(Playback, SeekingPassesEventsForwardsAndTakesThemBackInReverse) {
    Playback playback(Pacing::kSteady);
    play_with_events(playback);
    playback.seek(0.6);
    auto passed = playback.take_passed();
    ASSERT_EQ(passed.size(), 3U);
    EXPECT_EQ(std::get<ShotEvent>(passed[2]).t, 0.5);
    playback.seek(0.1);
    passed = playback.take_passed();
    ASSERT_EQ(passed.size(), 2U);
    EXPECT_EQ(std::get<Playback::TakenBack>(passed[0]).event.t, 0.5);
    EXPECT_EQ(std::get<Playback::TakenBack>(passed[1]).event.t, 0.25);
    playback.seek(0.25);
    EXPECT_EQ(playback.take_passed().size(), 1U) << "it is passed again";
}

TEST(Playback, SoughtEndIsLookedAtUntilTimePasses) {
    Playback playback(Pacing::kSteady);
    play_with_events(playback);
    playback.seek(9);
    EXPECT_EQ(playback.time(), 1);
    ASSERT_FALSE(playback.idle());
    EXPECT_TRUE(playback.step(-1));
    playback.seek(9);
    playback.advance(1.0 / 60);
    EXPECT_TRUE(playback.idle());
    EXPECT_EQ(count_ends(playback), 1);
}

TEST(Playback, SeekingStaysWithinWhatWasReceived) {
    Playback playback(Pacing::kLive);
    playback.seek(1);
    playback.begin(running_shot());
    receive_tick(playback, 1);
    playback.seek(1);
    EXPECT_EQ(playback.time(), kTick);
    playback.seek(-1);
    EXPECT_EQ(playback.time(), 0);
}

TEST(Playback, StepsBackwardsLeadOverTheSameMomentsToTheBeginning) {
    Playback playback(Pacing::kSteady);
    playback.begin(running_shot());
    receive_end(playback, 1);
    std::vector<double> moments;
    for (int step = 0; step < 5; ++step) {
        moments.push_back(playback.time());
        ASSERT_TRUE(playback.step());
    }
    for (std::size_t i = moments.size(); i-- > 0;) {
        ASSERT_TRUE(playback.step(-1));
        EXPECT_NEAR(playback.time(), moments[i], 1e-12);
    }
    EXPECT_EQ(playback.time(), 0);
    EXPECT_FALSE(playback.step(-1));
}

TEST(Playback, SeveralStepsAreOneMove) {
    Playback playback(Pacing::kSteady);
    playback.begin(running_shot());
    receive_end(playback, 1);
    ASSERT_TRUE(playback.step(10));
    EXPECT_DOUBLE_EQ(playback.time(), 10 * kTick);
    ASSERT_TRUE(playback.step(-3));
    EXPECT_DOUBLE_EQ(playback.time(), 7 * kTick);
    ASSERT_TRUE(playback.step(-99));
    EXPECT_EQ(playback.time(), 0);
}

TEST(Playback, RulingIsGoneAgainBeforeItIsCertain) {
    Playback playback(Pacing::kSteady);
    Shot shot = running_shot();
    shot.ruling = Ruling{};
    shot.ruling->decided_at = 0.4;
    playback.begin(std::move(shot));
    receive_end(playback, 1);
    playback.seek(0.5);
    EXPECT_TRUE(playback.ruling());
    playback.seek(0.3);
    EXPECT_FALSE(playback.ruling());
}

TEST(Playback, RulingShowsWhenItIsCertainOnTheScreen) {
    Playback playback(Pacing::kSteady);
    Shot shot = running_shot();
    shot.ruling = Ruling{};
    shot.ruling->decided_at = 0.4;
    playback.begin(std::move(shot));
    receive_end(playback, 1);
    playback.advance(0.3);
    EXPECT_FALSE(playback.ruling());
    playback.advance(0.2);
    EXPECT_TRUE(playback.ruling());
}

}  // namespace
}  // namespace poolhall::client
