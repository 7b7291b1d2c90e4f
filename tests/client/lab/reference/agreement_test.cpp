// The event solver in doubles against its reference.

#include "client/lab/corpora/scene_makers.hpp"
#include "tests/client/lab/reference/exact_shot.hpp"

#include <gtest/gtest.h>

namespace poolhall::lab {
namespace {

Scene cloth_shot(Random& random, std::size_t balls) {
    Scene scene = random_scene(random, balls, random.uniform(0.5, 5));
    scene.effects = cloth_effects();
    scene.solver.kind = SolverKind::kEvent;
    return scene;
}

void expect_same_events(const ShotTrace& expected, const ShotTrace& actual) {
    ASSERT_EQ(expected.events.size(), actual.events.size());
    for (std::size_t i = 0; i < expected.events.size(); ++i) {
        EXPECT_EQ(expected.events[i].kind, actual.events[i].kind) << "event " << i;
        EXPECT_EQ(expected.events[i].balls, actual.events[i].balls) << "event " << i;
        EXPECT_NEAR(expected.events[i].t, actual.events[i].t, 1e-10) << "event " << i;
    }
}

void expect_agreement(const Scene& scene, double tolerance) {
    const ShotTrace trace = simulate(scene);
    const ExactShot shot(scene);
    EXPECT_EQ(shot.trace().outcome, trace.outcome);
    expect_same_events(shot.trace(), trace);
    EXPECT_LE(shot.rest_error(trace), tolerance);
}

TEST(ReferenceAgreement, OneBallEndsWhereItShould) {
    Random random(1);
    for (int i = 0; i < 100; ++i)
        expect_agreement(cloth_shot(random, 1), 1e-13);
}

TEST(ReferenceAgreement, TwoBallsEndWhereTheyShould) {
    Random random(2);
    for (int i = 0; i < 100; ++i)
        expect_agreement(cloth_shot(random, 2), 2e-12);
}

TEST(ReferenceAgreement, NineBallBreakHasTheEventsThatItShould) {
    Scene scene = break_scene(3, 1e-4, 6);
    scene.effects = cloth_effects();
    scene.solver.kind = SolverKind::kEvent;
    scene.strike->direction = {1, 0.003};
    expect_agreement(scene, 1e-9);
}

/// A scene in which every field that a shot may depend on is other than its default.
Scene rich_scene() {
    Scene scene = scene_of({{-0.7, 0.1}, {0.2, 0.15}, {0.9, -0.3}});
    scene.table.length = 2.6;
    scene.table.width = 1.3;
    scene.table.pockets = PocketModel::kCircles;
    scene.table.circles = {{"a", {1.3, -0.65}, 0.07}, {"b", {-1.3, 0.65}, 0.06}};
    scene.ball = {0.03, 0.2};
    scene.gravity = 9.7;
    scene.effects = cloth_effects();
    scene.effects.sliding->mu = 0.21;
    scene.effects.rolling->mu = 0.012;
    scene.effects.spin_decay->mu = 0.03;
    scene.effects.ball_ball.friction_by_speed = FrictionBySpeed{0.02, 0.1, 1.1};
    scene.effects.ball_ball.e = 0.93;
    scene.effects.ball_ball.min_separation = 2e-4;
    scene.effects.rail.mu = 0.17;
    scene.effects.rail.nose_height = 0.037;
    scene.effects.airborne = AirborneSpec{0.45};
    scene.balls[1].radius = 0.026;
    scene.balls[2].mass = 0.15;
    scene.balls[2].state.v = {0.1, 0.2, 0};
    scene.balls[2].state.w = {1, 2, 30};
    scene.strike = Strike{BallIndex{0}, {1, 0.07}, 4, {0.2, -0.3}, 0.1, 0.03};
    scene.solver.kind = SolverKind::kEvent;
    return scene;
}

TEST(ReferenceAgreement, EveryFieldOfASceneArrives) {
    expect_agreement(rich_scene(), 1e-11);
}

TEST(ReferenceAgreement, LimitsHoldAsInDoubles) {
    Scene scene = rich_scene();
    scene.limits.time = 0.7;
    expect_agreement(scene, 1e-13);
    scene.limits = {600, 7};
    expect_agreement(scene, 1e-13);
}

TEST(ReferenceSimulator, MemoryThatIsUsedAgainLeavesNoTrace) {
    Random random(3);
    ReferenceSimulator simulator;
    ShotTrace trace;
    simulator.simulate(cloth_shot(random, 9), 30, trace);
    const Scene scene = cloth_shot(random, 3);
    simulator.simulate(scene, 0, trace);
    ShotTrace once;
    ReferenceSimulator().simulate(scene, 0, once);
    EXPECT_EQ(once.hash, trace.hash);
    EXPECT_EQ(once.events, trace.events);
    EXPECT_EQ(once.balls, trace.balls);
    EXPECT_TRUE(trace.samples.empty());
}

TEST(ReferenceSimulator, TraceIsWhatASimulatorWrites) {
    const Scene scene = rich_scene();
    ShotTrace trace;
    ReferenceSimulator().simulate(scene, 120, trace);
    const ShotTrace doubles = simulate(scene, 120);
    EXPECT_EQ(SolverKind::kEvent, trace.solver);
    EXPECT_EQ(hash_of(trace), trace.hash);
    EXPECT_EQ(120, trace.sample_hz);
    ASSERT_EQ(doubles.samples.size(), trace.samples.size());
    for (std::size_t i = 0; i < trace.samples.size(); ++i)
        EXPECT_LE(norm(doubles.samples[i] - trace.samples[i]), 1e-11) << "sample " << i;
}

TEST(ReferenceSimulator, RestIsLessThanHalfAUnitInTheLastPlace) {
    const Scene scene = rich_scene();
    ShotTrace trace;
    ShotTrace rest;
    ReferenceSimulator().simulate(scene, 0, trace, rest);
    ASSERT_EQ(trace.events.size(), rest.events.size());
    bool any = false;
    for (std::size_t i = 0; i < trace.events.size(); ++i) {
        EXPECT_LE(std::abs(rest.events[i].t), 0x1p-53 * trace.events[i].t);
        EXPECT_EQ(trace.events[i].kind, rest.events[i].kind);
        EXPECT_EQ(trace.events[i].balls, rest.events[i].balls);
        any = any || rest.events[i].t != 0;
    }
    EXPECT_TRUE(any);
    EXPECT_EQ(trace.balls[0].motion, rest.balls[0].motion);
    EXPECT_EQ(0U, rest.hash);
}

TEST(ReferenceSimulator, SceneWithoutBallsGivesAnEmptyTrace) {
    ShotTrace trace;
    ReferenceSimulator().simulate(Scene{}, 0, trace);
    EXPECT_TRUE(trace.events.empty());
    EXPECT_EQ(Outcome::kRest, trace.outcome);
}

}  // namespace
}  // namespace poolhall::lab
