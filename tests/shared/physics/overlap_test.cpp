#include "tests/shared/scenes.hpp"
#include "tests/shared/traces.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace poolhall {
namespace {

using testing::count;
using testing::events_of;
using testing::final_velocity;

constexpr double kDiameter = 2 * BallSpec{}.radius;

/// A ball that comes along x at `speed` m/s, `offset` m off the centre of one at rest.
Scene pass(double speed, double offset, double way, SolverKind solver) {
    Scene scene = testing::scene_of({{-way, 0}, {0, offset}});
    scene.table.rails = false;
    scene.strike = Strike{BallIndex{0}, {1, 0}, speed};
    scene.solver.kind = solver;
    scene.limits.time = (way + 0.2) / speed + 2.0 / 30;
    return scene;
}

TEST(Overlap, HitsThatItFindsHaveTheTimeAndTheVelocitiesOfTheSweptTest) {
    testing::Random random(1);
    int found = 0;
    for (int i = 0; i < 500; ++i) {
        const double offset = random.uniform(-0.9, 0.9) * kDiameter;
        const double way = random.uniform(0.1, 0.5);
        const auto hits =
            events_of(simulate(pass(2, offset, way, SolverKind::kOverlap)), EventKind::kBallBall);
        const auto swept =
            events_of(simulate(pass(2, offset, way, SolverKind::kEuler)), EventKind::kBallBall);
        ASSERT_EQ(1U, swept.size());
        if (hits.empty()) continue;
        ++found;
        EXPECT_NEAR(swept[0].t, hits[0].t, 1e-13);
        for (const std::size_t ball : {0U, 1U})
            EXPECT_LE(norm(xy(hits[0].after[ball].v) - xy(swept[0].after[ball].v)), 1e-12);
    }
    EXPECT_GT(found, 400);
}

struct Missed {
    double speed;    ///< m/s
    double percent;  ///< of true hits, SEED_FACTS
};

class OverlapMisses : public ::testing::TestWithParam<Missed> {};

TEST_P(OverlapMisses, ThatShareOfTrueHitsAt30Hz) {
    // The set-up behind the figures: one ball at rest, hit at a uniform speed, with the offset
    // uniform between the two grazes and the tick at any moment of the way. The share missed is the
    // mean over the offset of max(0, 1 - chord / step).
    const auto [speed, percent] = GetParam();
    testing::Random random(4);
    constexpr int kShots = 20000;
    int missed = 0;
    for (int i = 0; i < kShots; ++i) {
        const double offset = random.uniform(-1, 1) * kDiameter;
        const double way = kDiameter + random.uniform(0, 1) * speed / 30;
        missed += count(simulate(pass(speed, offset, way, SolverKind::kOverlap)),
                        EventKind::kBallBall) == 0;
    }
    EXPECT_NEAR(percent, 100.0 * missed / kShots, 1);
}

INSTANTIATE_TEST_SUITE_P(AtSpeeds, OverlapMisses,
                         ::testing::Values(Missed{1, 1.4}, Missed{3, 15}, Missed{5, 46},
                                           Missed{30, 91}));

TEST(Overlap, SlowHeadOnHitIsElastic) {
    Scene scene = pass(0.5, 0, 0.2, SolverKind::kOverlap);
    const ShotTrace trace = simulate(scene);
    EXPECT_NEAR(0, norm(final_velocity(trace, 0)), 1e-15);
    EXPECT_NEAR(0.5, final_velocity(trace, 1).x, 1e-15);
}

TEST(Overlap, FastBallIsReflectedUntilItIsOnTheTable) {
    Scene scene = testing::scene_of({0, 0}, {200, 70});
    scene.solver.kind = SolverKind::kOverlap;
    scene.limits.time = 1.0 / 30;
    const ShotTrace overlap = simulate(scene);
    scene.solver.kind = SolverKind::kEuler;
    const ShotTrace swept = simulate(scene);
    EXPECT_GT(count(overlap, EventKind::kBallRail), 3U);
    EXPECT_EQ(count(swept, EventKind::kBallRail), count(overlap, EventKind::kBallRail));
    EXPECT_EQ(swept.balls[0].state.v, overlap.balls[0].state.v);
    EXPECT_LE(norm(testing::final_place(swept, 0) - testing::final_place(overlap, 0)), 1e-13);
}

TEST(Overlap, BallsThatSeparateFromAnOverlapAreLeftAlone) {
    Scene scene = testing::scene_of({{0, 0}, {kDiameter - 0.9e-9, 0}});
    scene.balls[0].state.v.x = -1;
    scene.solver.kind = SolverKind::kOverlap;
    scene.limits.time = 0.2;
    EXPECT_EQ(0U, count(simulate(scene), EventKind::kBallBall));
}

TEST(Overlap, BallThatEndsATickInAPocketIsCaptured) {
    Scene scene = testing::scene_of({{0, 0}});
    scene.table.pockets = PocketModel::kEndGame;
    scene.effects.linear_drag = LinearDragSpec{};
    scene.solver.kind = SolverKind::kOverlap;
    scene.strike = Strike{BallIndex{0}, inset(scene.table, scene.ball.radius), 1.5};
    const ShotTrace trace = simulate(scene);
    EXPECT_EQ(Motion::kPocketed, trace.balls[0].motion);
    EXPECT_EQ(Pocket::kNorthEast, trace.balls[0].pocket);
}

}  // namespace
}  // namespace poolhall
