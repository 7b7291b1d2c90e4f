#include "client/play/overlays.hpp"

#include <array>
#include <gtest/gtest.h>

namespace poolhall::client {
namespace {

TEST(StepTrail, OnlyBallsThatMovedLeaveRings) {
    StepTrail trail;
    trail.step(std::array{Vec2{0, 0}, Vec2{1, 0}}, std::array{Vec2{0.1, 0}, Vec2{1, 0}});
    ASSERT_EQ(trail.rings().size(), 1U);
    EXPECT_EQ(trail.rings()[0].ball, BallIndex{0});
    EXPECT_EQ(trail.rings()[0].r, (Vec2{0, 0}));
}

TEST(StepTrail, RingsFadeWithFurtherStepsAndGo) {
    StepTrail trail;
    trail.step(std::array{Vec2{0, 0}}, std::array{Vec2{1, 0}});
    double last = trail.rings()[0].strength;
    for (int step = 1; step < StepTrail::kLife; ++step) {
        trail.step(std::array{Vec2{1, 0}}, std::array{Vec2{1, 0}});
        ASSERT_EQ(trail.rings().size(), 1U) << step;
        EXPECT_LT(trail.rings()[0].strength, last);
        last = trail.rings()[0].strength;
    }
    trail.step(std::array{Vec2{1, 0}}, std::array{Vec2{1, 0}});
    trail.step(std::array{Vec2{1, 0}}, std::array{Vec2{1, 0}});
    EXPECT_TRUE(trail.rings().empty());
}

ShotEvent event_at(double t, EventKind kind, std::uint8_t balls) {
    ShotEvent event;
    event.t = t;
    event.kind = kind;
    event.balls = {BallIndex{0}, BallIndex{1}};
    event.ball_count = balls;
    return event;
}

TEST(CollisionMarks, TwoForBallAndBallOneForARailNoneForTheRest) {
    ShotTimeline timeline(std::array{Vec2{0, 0}, Vec2{1, 0}});
    timeline.extend(
        1,
        std::array{event_at(0, EventKind::kStrike, 1), event_at(0.25, EventKind::kBallBall, 2),
                   event_at(0.5, EventKind::kBallRail, 1), event_at(0.6, EventKind::kRollToRest, 1),
                   event_at(0.7, EventKind::kBallPocket, 1)},
        {});
    EXPECT_EQ(collision_marks(timeline, 0.2).size(), 0U);
    EXPECT_EQ(collision_marks(timeline, 0.25).size(), 2U);
    EXPECT_EQ(collision_marks(timeline, 1).size(), 3U);
    EXPECT_EQ(collision_marks(timeline, 0.3).size(), 2U) << "at any time, in any order";
}

}  // namespace
}  // namespace poolhall::client
