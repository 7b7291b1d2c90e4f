#include "tests/shared/invariants.hpp"
#include "tests/shared/pressed_scenes.hpp"
#include "tests/shared/random.hpp"
#include "tests/shared/solvers.hpp"

#include <gtest/gtest.h>

namespace poolhall {
namespace {

class PressedClusters : public ::testing::TestWithParam<SolverKind> {};

INSTANTIATE_TEST_SUITE_P(Solvers, PressedClusters, ::testing::ValuesIn(testing::kSweptSolvers),
                         testing::solver_name);

TEST_P(PressedClusters, ComeToAnEndAndNeverOverlap) {
    testing::Random random(81);
    for (int i = 0; i < 400; ++i) {
        SCOPED_TRACE(i);
        Scene scene = testing::pressed_scene(random);
        scene.solver.kind = GetParam();
        if (check(scene)) continue;  // a ball in a mouth
        const ShotTrace trace = simulate(scene, 30);
        ASSERT_TRUE(trace.outcome == Outcome::kRest || trace.outcome == Outcome::kTimeLimit);
        ASSERT_EQ("", testing::broken_invariant(scene, trace, 1e-9));
    }
}

}  // namespace
}  // namespace poolhall
