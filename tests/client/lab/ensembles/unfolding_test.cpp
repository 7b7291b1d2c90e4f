#include "client/lab/ensembles/unfolding.hpp"

#include "client/lab/corpora/scene_makers.hpp"
#include "client/lab/ensembles/ensembles.hpp"
#include "client/lab/reference/reference.hpp"
#include "shared/analysis/agreement.hpp"
#include "shared/physics/simulate.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace poolhall::lab {
namespace {

/// Both traces tell the same, to `tolerance` (s, m and m/s).
void expect_equal(const ShotTrace& expected, const ShotTrace& actual, double tolerance) {
    ASSERT_TRUE(analysis::agreement(expected, actual).complete());
    for (std::size_t i = 0; i < expected.events.size(); ++i) {
        EXPECT_NEAR(expected.events[i].t, actual.events[i].t, tolerance);
        EXPECT_LE(norm(expected.events[i].after[0].r - actual.events[i].after[0].r), tolerance);
        EXPECT_LE(norm(expected.events[i].before[0].v - actual.events[i].before[0].v), tolerance);
        EXPECT_LE(norm(expected.events[i].after[0].v - actual.events[i].after[0].v), tolerance);
    }
    EXPECT_LE(norm(expected.balls[0].state.r - actual.balls[0].state.r), tolerance);
    EXPECT_NEAR(expected.duration, actual.duration, tolerance);
}

class Unfolding : public ::testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Chains, Unfolding, ::testing::Values("bank_chain_10", "bank_chain_1000"));

TEST_P(Unfolding, AgreesWithTheReferenceIn113BitsToTheLastDigit) {
    ReferenceSimulator reference;
    ShotTrace expected;
    ShotTrace actual;
    for (const Scene& scene : scenes_of(*find_ensemble(GetParam()), 3, 5)) {
        reference.simulate(scene, 0, expected);
        unfold(scene, 0, actual);
        // Both round the same number; the last event's is a square root of almost nothing.
        expect_equal(expected, actual, 1e-14);
    }
}

TEST(UnfoldedShot, OfAStraightWayIsSchoolPhysics) {
    Scene scene = scene_of(Vec2{0.25, 0}, Vec2{1, 0});
    scene.effects.rolling = RollingSpec{0.125};
    scene.gravity = 8;
    ShotTrace trace;
    unfold(scene, 0, trace);  // 1 m/s, 1 m/s^2: half a metre in 1 s
    ASSERT_EQ(trace.events.size(), 1U);
    EXPECT_EQ(trace.events[0].kind, EventKind::kRollToRest);
    EXPECT_EQ(trace.duration, 1);
    EXPECT_EQ(trace.balls[0].state.r, (Vec3{0.75, 0, 0}));
    EXPECT_EQ(trace.balls[0].motion, Motion::kStationary);
}

TEST(UnfoldedShot, SamplesAsTheSimulatorDoes) {
    const Scene scene = scenes_of(*find_ensemble("bank_chain_10"), 4, 1)[0];
    const ShotTrace expected = simulate(scene, 5);
    ShotTrace actual;
    unfold(scene, 5, actual);
    ASSERT_EQ(actual.sample_count(), expected.sample_count());
    for (std::size_t k = 0; k < actual.sample_count(); ++k)
        EXPECT_LE(norm(actual.sample(k, 0) - expected.sample(k, 0)), 1e-12) << k;
}

}  // namespace
}  // namespace poolhall::lab
