#include "client/play/shot_timeline.hpp"

#include "tests/client/play/fixtures.hpp"

#include <array>
#include <gtest/gtest.h>

namespace poolhall::client {
namespace {

constexpr double kTick = 1.0 / 30;
constexpr BallIndex kCue{0};
constexpr BallIndex kEight{1};

ShotEvent event_at(double t, EventKind kind, Vec2 r, BallIndex ball = kCue) {
    ShotEvent event;
    event.t = t;
    event.kind = kind;
    event.balls = {ball, ball};
    set_xy(event.after[0].r, r);
    set_xy(event.before[0].r, r);
    return event;
}

ShotTimeline two_balls() {
    return ShotTimeline(std::array{Vec2{0, 0}, Vec2{1, 0}});
}

TEST(ShotTimeline, IsStraightBetweenTicks) {
    ShotTimeline timeline = two_balls();
    timeline.extend(kTick, {}, std::array{ShotTimeline::Moved{kCue, {0.3, 0.6}}});
    const Vec2 half = timeline.position(kCue, kTick / 2);
    EXPECT_NEAR(half.x, 0.15, 1e-12);
    EXPECT_NEAR(half.y, 0.3, 1e-12);
    EXPECT_EQ(timeline.position(kEight, kTick / 2), (Vec2{1, 0}));
}

TEST(ShotTimeline, BounceBetweenTicksIsNotCutShort) {
    ShotTimeline timeline = two_balls();
    const Vec2 at_rail{0.5, 0.2};
    timeline.extend(kTick, std::array{event_at(kTick / 2, EventKind::kBallRail, at_rail)},
                    std::array{ShotTimeline::Moved{kCue, {0.1, 0.4}}});
    EXPECT_EQ(timeline.position(kCue, kTick / 2), at_rail);
    EXPECT_NEAR(timeline.position(kCue, kTick / 4).x, 0.25, 1e-12);
    EXPECT_NEAR(timeline.position(kCue, 0.75 * kTick).x, 0.3, 1e-12);
}

TEST(ShotTimeline, PositionIsHeldOutsideTheKnownTime) {
    ShotTimeline timeline = two_balls();
    timeline.extend(kTick, {}, std::array{ShotTimeline::Moved{kCue, {0.3, 0}}});
    EXPECT_EQ(timeline.position(kCue, -1), (Vec2{0, 0}));
    EXPECT_EQ(timeline.position(kCue, 5), (Vec2{0.3, 0}));
}

TEST(ShotTimeline, EndIsExactAndReplacesTheTickBehindIt) {
    ShotTimeline timeline = two_balls();
    timeline.extend(kTick, {}, std::array{ShotTimeline::Moved{kCue, {0.30001, 0}}});
    std::array<FinalBall, 2> balls;
    set_xy(balls[0].state.r, {0.300004, 0});
    set_xy(balls[1].state.r, {1, 0});
    timeline.finish(0.9 * kTick, balls);
    EXPECT_TRUE(timeline.complete());
    EXPECT_EQ(timeline.known_until(), 0.9 * kTick);
    EXPECT_EQ(timeline.position(kCue, kTick), (Vec2{0.300004, 0}));
}

TEST(ShotTimeline, BallIsSunkFromItsCaptureOn) {
    ShotTimeline timeline = two_balls();
    const Vec2 pocket{1.2, 0.5};
    timeline.extend(kTick, std::array{event_at(kTick / 2, EventKind::kBallPocket, pocket, kEight)},
                    std::array{ShotTimeline::Moved{kEight, pocket}});
    EXPECT_FALSE(timeline.sunk(kEight, kTick / 4));
    EXPECT_TRUE(timeline.sunk(kEight, kTick / 2));
    EXPECT_FALSE(timeline.sunk(kCue, kTick));
}

TEST(ShotTimeline, WhatIsNotOfThisShotIsIgnored) {
    ShotTimeline timeline = two_balls();
    const BallIndex stranger{7};
    timeline.extend(kTick, std::array{event_at(0.01, EventKind::kBallRail, {9, 9}, stranger)},
                    std::array{ShotTimeline::Moved{stranger, {9, 9}}});
    EXPECT_TRUE(timeline.events().empty());
    timeline.extend(kTick / 2, {}, std::array{ShotTimeline::Moved{kCue, {9, 9}}});
    EXPECT_EQ(timeline.position(kCue, kTick), (Vec2{0, 0}));
    EXPECT_EQ(timeline.known_until(), kTick);
}

TEST(ShotTimeline, LateComerStartsInTheMiddle) {
    ShotTimeline timeline(std::array{Vec2{0.5, 0}}, 10 * kTick);
    timeline.extend(11 * kTick, {}, std::array{ShotTimeline::Moved{kCue, {0.6, 0}}});
    EXPECT_NEAR(timeline.position(kCue, 10.5 * kTick).x, 0.55, 1e-12);
}

TEST(ShotTimeline, EventsAreCountedUpToAnyTimeInAnyOrder) {
    ShotTimeline timeline = two_balls();
    timeline.extend(kTick,
                    std::array{event_at(0, EventKind::kStrike, {0, 0}),
                               event_at(kTick / 2, EventKind::kBallRail, {0.1, 0})},
                    {});
    EXPECT_EQ(timeline.events_until(kTick), 2U);
    EXPECT_EQ(timeline.events_until(-1), 0U);
    EXPECT_EQ(timeline.events_until(kTick / 2), 2U);
    EXPECT_EQ(timeline.events_until(kTick / 4), 1U);
    EXPECT_EQ(timeline.events_until(0), 1U);
}

TEST(ShotTimeline, ShotThatIsKnownWholeGoesThroughItsSamplesAndEndsExactly) {
    const SimulatedShot shot = *turn_of(new_table().state, {1, 0.03}).shot;
    const ShotTrace& trace = shot.trace;
    const ShotTimeline timeline = timeline_of(shot);
    EXPECT_TRUE(timeline.complete());
    EXPECT_EQ(timeline.known_until(), trace.duration);
    EXPECT_EQ(timeline.events().size(), trace.events.size());
    for (std::size_t k = trace.sample_count() - 1; k-- > 0;) {
        const double t = static_cast<double>(k) / trace.sample_hz;
        for (std::uint16_t i = 0; i < 2; ++i)
            EXPECT_NEAR(norm(timeline.position({i}, t) - xy(trace.sample(k, i))), 0, 1e-9) << t;
    }
    EXPECT_EQ(timeline.position(kEight, trace.duration), xy(trace.balls[1].state.r));
}

}  // namespace
}  // namespace poolhall::client
