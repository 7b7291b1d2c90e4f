// Laws that every shot obeys at every tick, by every solver, on real cloth.

#include "tests/shared/invariants.hpp"
#include "tests/shared/random.hpp"
#include "tests/shared/scenes.hpp"
#include "tests/shared/solvers.hpp"
#include "tests/shared/traces.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace poolhall {
namespace {

class EveryTickOfAShot : public ::testing::TestWithParam<SolverKind> {
  protected:
    static double overlap() { return GetParam() == SolverKind::kEvent ? 1e-12 : 1e-9; }
};

INSTANTIATE_TEST_SUITE_P(Solvers, EveryTickOfAShot, ::testing::ValuesIn(testing::kSweptSolvers),
                         testing::solver_name);

/// Balls anywhere, one struck anywhere on its face, on one of three kinds of table.
Scene shot_number(int i, testing::Random& random) {
    Scene scene = testing::random_scene(random, 1 + random.below(16), random.uniform(0.1, 12));
    scene.effects = i % 2 == 0 ? testing::cloth_effects() : testing::pool_effects();
    scene.strike->offset = random.uniform(0, 0.6) * random.direction();
    if (i % 3 == 1) {
        scene.table.pockets = PocketModel::kCircles;
        scene.table.circles = {{"NE", {1.27, 0.635}, 0.06}, {"S", {0, -0.635}, 0.05}};
    }
    return scene;
}

/// A rack with a small gap, broken off its axis.
Scene break_number(int i, testing::Random& random) {
    Scene scene = testing::break_scene(2 + i % 4, std::pow(10, random.uniform(-6, -2)),
                                       random.uniform(1, 12));
    scene.effects = i % 2 == 0 ? testing::cloth_effects() : testing::pool_effects();
    scene.strike->direction.y = random.uniform(-0.05, 0.05);
    scene.strike->offset = {random.uniform(-0.3, 0.3), random.uniform(-0.5, 0.5)};
    return scene;
}

TEST_P(EveryTickOfAShot, ObeysTheLaws) {
    testing::Random random(71);
    for (int i = 0; i < 200; ++i) {
        SCOPED_TRACE(i);
        Scene scene = i % 4 == 3 ? break_number(i, random) : shot_number(i, random);
        scene.solver.kind = GetParam();
        if (check(scene)) continue;  // a ball in a pocket
        const ShotTrace trace = simulate(scene, 30);
        ASSERT_EQ(Outcome::kRest, trace.outcome);
        ASSERT_EQ("", testing::broken_invariant(scene, trace, overlap()));
    }
}

TEST_P(EveryTickOfAShot, ShotsEndWithinTheTimeThatRollingAloneMayTake) {
    testing::Random random(72);
    for (int i = 0; i < 200; ++i) {
        SCOPED_TRACE(i);
        Scene scene = shot_number(2 * i, random);
        scene.solver.kind = GetParam();
        const double speed = scene.strike->speed;
        const auto count = static_cast<double>(scene.balls.size());
        const ShotTrace trace = simulate(scene);
        ASSERT_EQ(Outcome::kRest, trace.outcome);
        // The ball that has the most energy, E / n at least, loses it no slower than by rolling:
        // dE/dt <= -mu g sqrt(10 E / (7 n)). Of the strike, spin has at most 2.5 offset^2 of v^2.
        const double energy = speed * speed / 2 * (1 + 2.5);
        EXPECT_LE(trace.duration, 2 * std::sqrt(energy * 0.7 * count) / (0.01 * 9.81) + 1);
    }
}

TEST_P(EveryTickOfAShot, JumpsObeyTheLawsToo) {
    const bool sinks = GetParam() == SolverKind::kEuler || GetParam() == SolverKind::kSemiImplicit;
    // A ball that sinks into the slate within a tick is put back onto it, whoever is above.
    const double allowed = sinks ? 0.02 : overlap();
    testing::Random random(73);
    std::size_t lost = 0;
    for (int i = 0; i < 200; ++i) {
        SCOPED_TRACE(i);
        Scene scene = shot_number(i, random);
        scene.effects.airborne = AirborneSpec{random.uniform(0, 0.8)};
        scene.strike->elevation = random.uniform(0.1, 1.5);
        scene.solver = {GetParam(), 120};
        const ShotTrace trace = simulate(scene, 30);
        ASSERT_EQ(Outcome::kRest, trace.outcome);
        ASSERT_EQ("", testing::broken_invariant(scene, trace, allowed));
        lost += testing::count(trace, EventKind::kOffTable);
    }
    EXPECT_LT(5U, lost);
}

}  // namespace
}  // namespace poolhall
