// A shot uses no heap once its Simulator and its trace have room: counted by a program
// of its own, whose operator new is replaced.

#include "shared/physics/simulate.hpp"
#include "tests/shared/allocation_counter.hpp"
#include "tests/shared/scenes.hpp"
#include "tests/shared/solvers.hpp"

#include <gtest/gtest.h>

namespace poolhall {
namespace {

class Allocation : public ::testing::TestWithParam<SolverKind> {
  protected:
    static void expect_none_the_second_time(Scene scene) {
        scene.solver.kind = GetParam();
        ASSERT_FALSE(check(scene));
        Simulator simulator;
        ShotTrace trace;
        simulator.simulate(scene, 30, trace);
        const std::uint64_t first = trace.hash;
        const long before = testing::allocations();
        simulator.simulate(scene, 30, trace);
        EXPECT_EQ(before, testing::allocations());
        EXPECT_GT(before, 0);
        EXPECT_EQ(first, trace.hash);
        EXPECT_GT(trace.events.size(), 20U);
    }
};

INSTANTIATE_TEST_SUITE_P(Solvers, Allocation, ::testing::ValuesIn(testing::kAllSolvers),
                         testing::solver_name);

TEST_P(Allocation, ABreakUnderDragAllocatesNothingTheSecondTime) {
    Scene scene = testing::break_scene(5, 0, 8);
    scene.table.pockets = PocketModel::kEndGame;
    expect_none_the_second_time(scene);
}

TEST_P(Allocation, ABreakOnClothAllocatesNothingTheSecondTime) {
    for (const double gap : {1e-4, 3e-3}) {
        Scene scene = testing::break_scene(4, gap, 6);
        scene.effects = testing::pool_effects();
        scene.strike->offset = {0.2, 0.3};
        expect_none_the_second_time(scene);
    }
}

TEST_P(Allocation, MathavansRailsAndMouthsAllocateNothingTheSecondTime) {
    if (GetParam() == SolverKind::kOverlap) return;  // knows no mouths
    Scene scene = testing::break_scene(4, 3e-3, 9);
    scene.effects = testing::pool_effects();
    scene.effects.rail.model = RailModel::kMathavan2010;
    scene.table.pockets = PocketModel::kPool;
    expect_none_the_second_time(scene);
}

}  // namespace
}  // namespace poolhall
