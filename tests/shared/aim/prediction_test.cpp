#include "shared/aim/prediction.hpp"

#include "shared/game/end_game.hpp"
#include "tests/shared/scenes.hpp"
#include "tests/shared/traces.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace poolhall {
namespace {

constexpr double kDiameter = 2 * BallSpec{}.radius;
constexpr BallIndex kCue{0};

/// The direction of a path, or zero for a path of no length.
Vec2 direction_of(const PathSegment& path) {
    return normalized(path.to - path.from);
}

double distance(Vec2 a, Vec2 b) {
    return norm(a - b);
}

/// The first event after the strike, without friction.
ShotEvent first_event(Scene scene, Vec2 direction) {
    scene.effects.linear_drag.reset();
    scene.strike = Strike{kCue, direction, 2};
    scene.limits.events = 2;
    return simulate(scene).events.at(1);
}

TEST(AimPrediction, IsWhatTheSimulationDoes) {
    testing::Random random(1);
    int ghosts = 0;
    for (int i = 0; i < 2000; ++i) {
        const Scene scene = testing::random_scene(random, 2 + random.below(6), 1);
        const Vec2 direction = random.direction();
        const AimPrediction aim = predict(scene, kCue, direction);
        const ShotEvent event = first_event(scene, direction);
        ASSERT_EQ(event.kind == EventKind::kBallBall, aim.ghost_ball.has_value()) << i;
        EXPECT_LE(distance(xy(event.before[0].r), aim.cue_path.to), 1e-12);
        if (!aim.ghost_ball) continue;
        ++ghosts;
        EXPECT_EQ(event.balls[1], aim.object_ball);
        EXPECT_LE(distance(xy(event.before[0].r), *aim.ghost_ball), 1e-12);
        EXPECT_LE(distance(normalized(xy(event.after[1].v)), direction_of(*aim.object_after)),
                  1e-9);
        if (aim.cue_after) {
            EXPECT_LE(distance(normalized(xy(event.after[0].v)), direction_of(*aim.cue_after)),
                      1e-9);
        }
    }
    EXPECT_GT(ghosts, 150);
}

TEST(AimPrediction, PathsAfterTheHitEndAtARail) {
    const Scene scene = kEndGameRules.new_game(Seat{0}).scene;
    const Vec2 edge = inset(scene.table, scene.ball.radius);
    const AimPrediction aim = predict(scene, kCue, {1, 0.03});
    ASSERT_TRUE(aim.cue_after && aim.object_after);
    for (const PathSegment& path : {*aim.cue_after, *aim.object_after}) {
        const bool at_rail = std::abs(std::abs(path.to.x) - edge.x) < 1e-12 ||
                             std::abs(std::abs(path.to.y) - edge.y) < 1e-12;
        EXPECT_TRUE(at_rail);
    }
    EXPECT_EQ(*aim.ghost_ball, aim.cue_after->from);
    EXPECT_EQ(xy(scene.balls[1].state.r), aim.object_after->from);
}

TEST(AimPrediction, GhostBallTouchesTheObjectBall) {
    const Scene scene = kEndGameRules.new_game(Seat{0}).scene;
    for (const double slope : {0.0, 0.01, -0.03, 0.065}) {
        const AimPrediction aim = predict(scene, kCue, {1, slope});
        ASSERT_TRUE(aim.ghost_ball) << slope;
        EXPECT_NEAR(kDiameter, distance(*aim.ghost_ball, xy(scene.balls[1].state.r)), 1e-15);
    }
}

TEST(AimPrediction, FullHitStopsTheCueBall) {
    const AimPrediction aim = predict(kEndGameRules.new_game(Seat{0}).scene, kCue, {5, 0});
    ASSERT_TRUE(aim.object_after);
    EXPECT_FALSE(aim.cue_after);
}

TEST(AimPrediction, RailBeforeTheBallMeansNoGhost) {
    const Scene scene = kEndGameRules.new_game(Seat{0}).scene;
    const AimPrediction aim = predict(scene, kCue, {1, 1});
    EXPECT_FALSE(aim.ghost_ball);
    EXPECT_FALSE(aim.object_ball);
    EXPECT_FALSE(aim.cue_after);
    EXPECT_FALSE(aim.object_after);
    EXPECT_NEAR(inset(scene.table, scene.ball.radius).y, aim.cue_path.to.y, 1e-15);
}

TEST(AimPrediction, ZeroDirectionGivesAnEmptyPath) {
    const Scene scene = kEndGameRules.new_game(Seat{0}).scene;
    const AimPrediction aim = predict(scene, kCue, {});
    EXPECT_EQ(xy(scene.balls[0].state.r), aim.cue_path.from);
    EXPECT_EQ(aim.cue_path.from, aim.cue_path.to);
    EXPECT_FALSE(aim.ghost_ball);
}

TEST(AimPrediction, LengthOfTheDirectionDoesNotMatter) {
    const Scene scene = kEndGameRules.new_game(Seat{0}).scene;
    const Vec2 expected = predict(scene, kCue, {4, 0.25}).ghost_ball.value();
    for (const double length : {1e-300, 0.25, 1e200}) {
        const Vec2 ghost = predict(scene, kCue, {4 * length, 0.25 * length}).ghost_ball.value();
        EXPECT_LE(distance(expected, ghost), 1e-15);
    }
}

TEST(AimPrediction, EndlessClothEndsThePathAtItsReach) {
    Scene scene = testing::scene_of({{0, 0}});
    scene.table.rails = false;
    EXPECT_NEAR(3, norm(predict(scene, kCue, {-3, 4}, 3).cue_path.to), 1e-15);
}

TEST(AimPrediction, TouchingBallAheadIsHitAtOnceAndOneBehindIsNot) {
    const Scene scene = testing::scene_of({{0, 0}, {kDiameter, 0}});
    EXPECT_EQ((Vec2{}), predict(scene, kCue, {1, 0}).ghost_ball);
    EXPECT_FALSE(predict(scene, kCue, {-1, 0}).ghost_ball);
}

}  // namespace
}  // namespace poolhall
