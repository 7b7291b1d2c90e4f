#include "shared/game/end_game.hpp"
#include "tests/shared/scenes.hpp"
#include "tests/shared/traces.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace poolhall {
namespace {

using testing::count;
using testing::events_of;
using testing::final_place;
using testing::final_velocity;

constexpr double kDiameter = 2 * BallSpec{}.radius;

Scene shot_of_the_original() {
    Scene scene = testing::scene_of({{0, 0}});
    scene.table.rails = false;
    scene.effects.linear_drag = LinearDragSpec{end_game::kDrag, end_game::kStopSpeed};
    scene.strike = Strike{BallIndex{0}, {1, 0}, end_game::kShotSpeed};
    return scene;
}

TEST(Euler, FreeRollIsThatOfTheOriginal) {
    for (const double hz : {30.0, 60.0}) {
        Scene scene = shot_of_the_original();
        scene.solver.hz = hz;
        const ShotTrace trace = simulate(scene);
        EXPECT_NEAR(6.2, trace.duration, 0.05);
        EXPECT_NEAR(2441, final_place(trace, 0).x / end_game::kPixel, 2);
    }
}

TEST(Euler, FreeRollIsTheGeometricSum) {
    const ShotTrace trace = simulate(shot_of_the_original());
    double x = 0;
    double v = end_game::kShotSpeed;
    std::uint64_t ticks = 0;
    while (v >= end_game::kStopSpeed) {
        x += v / 30;
        v *= 1 - end_game::kDrag / 30;
        ++ticks;
    }
    EXPECT_EQ(ticks, trace.ticks);
    EXPECT_NEAR(x, final_place(trace, 0).x, 1e-13);
    EXPECT_EQ((Vec2{}), final_velocity(trace, 0));
    EXPECT_EQ(Motion::kStationary, trace.balls[0].motion);
}

TEST(Euler, BallThatDragLeavesNoSpeedIsAtRestInEveryKernel) {
    // All of its speed is lost in one tick; there is no stop speed that it could fall below.
    Scene scene = testing::scene_of({0, 0}, {1, 0.5});
    scene.effects.linear_drag = LinearDragSpec{30, 0};
    for (const std::string_view kernel : kernel_names()) {
        ShotTrace trace;
        if (!simulate_by(kernel, scene, 0, trace)) continue;
        EXPECT_EQ(Outcome::kRest, trace.outcome) << kernel;
        EXPECT_EQ(1U, trace.ticks) << kernel;
        EXPECT_EQ(1U, count(trace, EventKind::kRollToRest)) << kernel;
    }
}

TEST(Euler, ErrorOfTheDragFallsWithTheFirstOrder) {
    // Without a stop speed, r(t) = (v / k) (1 - exp(-k t)).
    Scene scene = shot_of_the_original();
    scene.effects.linear_drag->stop_speed = 0;
    scene.limits.time = 2;
    const double k = end_game::kDrag;
    const double exact = end_game::kShotSpeed / k * (1 - std::exp(-k * scene.limits.time));
    const auto error_at = [&](double hz) {
        scene.solver.hz = hz;
        return std::abs(final_place(simulate(scene), 0).x - exact);
    };
    EXPECT_NEAR(1, std::log2(error_at(240) / error_at(480)), 0.01);
    EXPECT_NEAR(1, std::log2(error_at(480) / error_at(960)), 0.01);
}

TEST(Euler, SamplesAtTheSolversRateAreThePlacesOfItsTicks) {
    testing::Random random(9);
    Scene scene = testing::random_scene(random, 5, 6);
    const ShotTrace trace = simulate(scene, 30);
    ASSERT_EQ(trace.ticks + 1, trace.sample_count());
    for (const std::size_t k : {std::size_t{1}, std::size_t{7}, std::size_t{40}}) {
        scene.limits.time = static_cast<double>(k) / 30;
        const ShotTrace until = simulate(scene);
        for (std::size_t ball = 0; ball < scene.balls.size(); ++ball)
            EXPECT_EQ(final_place(until, ball), xy(trace.sample(k, ball)));
    }
}

TEST(Euler, FinerSamplesAgreeWithCoarserOnes) {
    testing::Random random(10);
    const Scene scene = testing::random_scene(random, 5, 6);
    const ShotTrace coarse = simulate(scene, 30);
    const ShotTrace fine = simulate(scene, 240);
    ASSERT_EQ(8 * (coarse.sample_count() - 1) + 1, fine.sample_count());
    for (std::size_t k = 0; k < coarse.sample_count(); ++k) {
        for (std::size_t ball = 0; ball < scene.balls.size(); ++ball)
            EXPECT_EQ(coarse.sample(k, ball), fine.sample(8 * k, ball));
    }
}

TEST(Euler, LastSampleIsTheFirstAtOrAfterTheEnd) {
    const Scene scene = shot_of_the_original();
    for (const double hz : {7.0, 30.0, 60.0, 1000.0}) {
        const ShotTrace trace = simulate(scene, hz);
        const auto last = static_cast<double>(trace.sample_count() - 1);
        EXPECT_GE(last / hz, trace.duration);
        EXPECT_LT((last - 1) / hz, trace.duration);
        EXPECT_EQ(final_place(trace, 0), xy(trace.sample(trace.sample_count() - 1, 0)));
    }
}

TEST(Euler, StrikeComesFirstAndSetsTheSpeedInTheGivenDirection) {
    for (const double length : {1e-300, 1.0, 1e200}) {
        Scene scene = shot_of_the_original();
        scene.strike->direction = {-0.6 * length, 0.8 * length};
        const ShotTrace trace = simulate(scene);
        ASSERT_EQ(EventKind::kStrike, trace.events.front().kind);
        EXPECT_EQ(0, trace.events.front().t);
        EXPECT_EQ(Vec3{}, trace.events.front().before[0].v);
        EXPECT_NEAR(-0.6 * end_game::kShotSpeed, trace.events.front().after[0].v.x, 1e-15);
        EXPECT_NEAR(0.8 * end_game::kShotSpeed, trace.events.front().after[0].v.y, 1e-15);
    }
}

TEST(Euler, RestIsTheLastEventOfAShot) {
    const ShotTrace trace = simulate(testing::break_scene(5, 0, 8));
    EXPECT_EQ(Outcome::kRest, trace.outcome);
    EXPECT_EQ(EventKind::kRollToRest, trace.events.back().kind);
    EXPECT_EQ(trace.events.back().t, trace.duration);
}

TEST(Euler, NothingThatMovesGivesAnEmptyTrace) {
    const ShotTrace trace = simulate(testing::scene_of({{0, 0}, {0.3, 0}}), 30);
    EXPECT_EQ(Outcome::kRest, trace.outcome);
    EXPECT_TRUE(trace.events.empty());
    EXPECT_EQ(0, trace.duration);
    EXPECT_EQ(1U, trace.sample_count());
    const ShotTrace empty = simulate(Scene{}, 30);
    EXPECT_EQ(Outcome::kRest, empty.outcome);
    EXPECT_EQ(0U, empty.sample_count());
}

TEST(Euler, TimeLimitEndsInTheMiddleOfATick) {
    Scene scene = testing::scene_of({0, 0}, {1, 0});
    scene.limits.time = 0.05;
    const ShotTrace trace = simulate(scene, 30);
    EXPECT_EQ(Outcome::kTimeLimit, trace.outcome);
    EXPECT_EQ(0.05, trace.duration);
    EXPECT_DOUBLE_EQ(0.05, final_place(trace, 0).x);
    EXPECT_EQ(Motion::kRolling, trace.balls[0].motion);
}

TEST(Euler, EventLimitEndsTheShot) {
    Scene scene = testing::scene_of({0, 0}, {3, 1});
    scene.limits.events = 5;
    const ShotTrace trace = simulate(scene);
    EXPECT_EQ(Outcome::kEventLimit, trace.outcome);
    EXPECT_EQ(5U, trace.events.size());
}

TEST(Euler, MoreContactsInATickThanTheBoundIsAStall) {
    Scene scene = testing::scene_of({0, 0}, {1e6, 0});
    scene.solver.hz = 1;
    const ShotTrace trace = simulate(scene);
    EXPECT_EQ(Outcome::kStalled, trace.outcome);
    EXPECT_EQ("stalled", name(trace.outcome));
}

TEST(Euler, BallThatLeavesARailWithRestitutionIsSlower) {
    Scene scene = testing::scene_of({0, 0}, {2, 0.5});
    scene.effects.rail = {RailModel::kRestitution, 0.5};
    scene.limits.events = 1;
    const ShotTrace trace = simulate(scene);
    ASSERT_EQ(1U, count(trace, EventKind::kBallRail));
    const ShotEvent& rail = trace.events[0];
    EXPECT_EQ(Rail::kEast, rail.rail);
    EXPECT_EQ((Vec3{2, 0.5, 0}), rail.before[0].v);
    EXPECT_EQ((Vec3{-1, 0.5, 0}), rail.after[0].v);
    EXPECT_EQ(inset(scene.table, scene.ball.radius).x, rail.after[0].r.x);
    EXPECT_DOUBLE_EQ(rail.after[0].r.x / 2, rail.t);
}

TEST(Euler, RestitutionOfTheElasticModelIsNotUsed) {
    Scene scene = testing::scene_of({0, 0}, {2, 1});
    scene.limits.time = 5;
    const std::uint64_t elastic = simulate(scene).hash;
    scene.effects.rail.e = 0.5;
    EXPECT_EQ(elastic, simulate(scene).hash);
}

TEST(Euler, CapturedBallStopsWhereItIsAndMeetsNothingMore) {
    Scene scene = testing::scene_of({{0, 0}, {0.9, 0.5}});
    scene.table.pockets = PocketModel::kEndGame;
    const Vec2 corner = inset(scene.table, scene.ball.radius);
    scene.strike = Strike{BallIndex{0}, corner, 2};
    scene.balls[1].state.r = {-0.9, 0.1, 0};
    const ShotTrace trace = simulate(scene);
    const auto captures = events_of(trace, EventKind::kBallPocket);
    ASSERT_EQ(1U, captures.size());
    EXPECT_EQ(Pocket::kNorthEast, captures[0].pocket);
    EXPECT_EQ(Motion::kPocketed, trace.balls[0].motion);
    EXPECT_EQ(captures[0].before[0].r, trace.balls[0].state.r);
    EXPECT_EQ(Vec3{}, trace.balls[0].state.v);
    EXPECT_EQ(0U, count(trace, EventKind::kBallRail));
    EXPECT_EQ(Motion::kStationary, trace.balls[1].motion);
}

TEST(Euler, DragLeavesTheSpinAsItIs) {
    Scene scene = testing::scene_of({0, 0}, {1, 1});
    scene.effects.linear_drag = LinearDragSpec{};
    scene.balls[0].state.w = {1, 2, 3};
    EXPECT_EQ((Vec3{1, 2, 3}), simulate(scene).balls[0].state.w);
}

TEST(Euler, UsedAgainATraceIsAsNew) {
    ShotTrace trace;
    simulate(testing::break_scene(5, 0, 8), 120, trace);
    const Scene scene = shot_of_the_original();
    simulate(scene, 30, trace);
    const ShotTrace fresh = simulate(scene, 30);
    EXPECT_EQ(fresh.hash, trace.hash);
    EXPECT_EQ(fresh.samples, trace.samples);
    EXPECT_EQ(fresh.events, trace.events);
}

TEST(Euler, DirectHitIsFoundAtItsTimeAtEveryRate) {
    for (const double hz : {1.0, 10.0, 30.0, 120.0, 7680.0}) {
        Scene scene = testing::scene_of({{-0.5, 0}, {0.5, 0}});
        scene.strike = Strike{BallIndex{0}, {1, 0}, 3};
        scene.solver.hz = hz;
        scene.limits.time = 0.4;
        const auto hits = events_of(simulate(scene), EventKind::kBallBall);
        ASSERT_EQ(1U, hits.size());
        EXPECT_NEAR(1, hits[0].t * 3 / (1 - kDiameter), 1e-14);
        EXPECT_EQ(simulate(scene).hash, simulate(scene).hash);
    }
}

}  // namespace
}  // namespace poolhall
