#include "shared/physics/solvers/solvers.hpp"

#include "shared/physics/simulate.hpp"
#include "tests/shared/scenes.hpp"
#include "tests/shared/solvers.hpp"

#include <gtest/gtest.h>

namespace poolhall {
namespace {

TEST(Solvers, StandInTheOrderOfTheirKinds) {
    for (const SolverKind kind : kValues<SolverKind>)
        EXPECT_EQ(kind, solver_of(kind).kind) << name(kind);
}

TEST(Solvers, HaveTicksIfTheirTracesDo) {
    for (const SolverKind kind : kValues<SolverKind>) {
        Scene scene = testing::break_scene(2, 0, 3);
        scene.solver.kind = kind;
        EXPECT_EQ(has_ticks(kind), simulate(scene).ticks > 0) << name(kind);
    }
}

TEST(Solvers, KeepTheirMemoryApartWhenTheyTakeTurns) {
    Simulator simulator;
    ShotTrace trace;
    for (int round = 0; round < 2; ++round) {
        for (const SolverKind kind : kValues<SolverKind>) {
            Scene scene = testing::break_scene(2, 0, 3);
            scene.solver.kind = kind;
            simulator.simulate(scene, 0, trace);
            EXPECT_EQ(simulate(scene).hash, trace.hash) << name(kind);
        }
    }
}

}  // namespace
}  // namespace poolhall
