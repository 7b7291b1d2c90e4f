// Racks that touch or nearly do, on real cloth: cloth friction presses balls together again, which
// makes endless loops of simulators that step from event to event.

#include "tests/shared/invariants.hpp"
#include "tests/shared/scenes.hpp"
#include "tests/shared/solvers.hpp"

#include <algorithm>
#include <cstdio>
#include <gtest/gtest.h>

namespace poolhall {
namespace {

constexpr std::size_t kMostEvents = 500;

Scene rack(double gap, double speed, Vec2 direction, const Effects& effects) {
    Scene scene = testing::break_scene(5, gap, speed);
    scene.effects = effects;
    scene.strike->direction = direction;
    scene.solver.kind = SolverKind::kEvent;
    return scene;
}

class RackWithGap : public ::testing::TestWithParam<double> {};

INSTANTIATE_TEST_SUITE_P(Gaps, RackWithGap, ::testing::Values(0, 1e-9, 1e-6, 1e-5, 1e-4, 1e-3));

TEST_P(RackWithGap, IsBrokenInAtMost500Events) {
    std::size_t most = 0;
    int too_many = 0;
    int breaks = 0;
    for (const Effects& effects : {testing::cloth_effects(), testing::pool_effects()}) {
        for (int speed = 1; speed <= 13; ++speed) {
            for (const double aside : {0.0, 0.003, -0.02, 0.045}) {
                SCOPED_TRACE(::testing::Message() << speed << " m/s, " << aside << " aside");
                const Scene scene = rack(GetParam(), speed, {1, aside}, effects);
                const ShotTrace trace = simulate(scene, 30);
                ++breaks;
                most = std::max(most, trace.events.size());
                too_many += trace.events.size() > kMostEvents;
                EXPECT_EQ(Outcome::kRest, trace.outcome);
                EXPECT_EQ("", testing::broken_invariant(scene, trace, 1e-12));
            }
        }
    }
    std::printf("gap %g m: at most %zu events, %d of %d breaks above %zu\n", GetParam(), most,
                too_many, breaks, kMostEvents);
    EXPECT_EQ(0, too_many);
}

}  // namespace
}  // namespace poolhall
