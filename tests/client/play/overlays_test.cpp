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

TEST(CollisionMarks, TwoForBallAndBallOneForARailNoneForTheRest) {
    CollisionMarks marks;
    ShotEvent event;
    event.kind = EventKind::kBallBall;
    event.ball_count = 2;
    marks.pass(event);
    EXPECT_EQ(marks.marks().size(), 2U);
    event.kind = EventKind::kBallRail;
    event.ball_count = 1;
    marks.pass(event);
    EXPECT_EQ(marks.marks().size(), 3U);
    for (const EventKind kind :
         {EventKind::kStrike, EventKind::kRollToRest, EventKind::kBallPocket}) {
        event.kind = kind;
        marks.pass(event);
    }
    EXPECT_EQ(marks.marks().size(), 3U);
    marks.pass(Playback::ShotBegan{});
    EXPECT_TRUE(marks.marks().empty());
}

}  // namespace
}  // namespace poolhall::client
