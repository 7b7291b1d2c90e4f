// An effect that is not in the library; shared/physics/effects/README.md shows how one gets into
// it.

#include "shared/physics/effects/effect_set.hpp"
#include "shared/physics/effects/rails.hpp"
#include "shared/physics/effects/rolling.hpp"
#include "shared/physics/effects/sliding.hpp"
#include "shared/physics/solvers/stepping.hpp"
#include "tests/shared/scenes.hpp"
#include "tests/shared/solvers.hpp"
#include "tests/shared/traces.hpp"

#include <gtest/gtest.h>

namespace poolhall {
namespace {

/// A table that is not level: it falls to the south by a millimetre a metre.
class TiltedTable {
  public:
    explicit TiltedTable(const Scene& scene) : acceleration_{0, -0.001 * scene.gravity} {}

    [[nodiscard]] static bool called_for(const Scene& scene) { return scene.gravity > 0; }

    void push(MovingBall& ball, double dt) const {
        if (moves_centre(ball.motion)) ball.v = ball.v + dt * acceleration_;
    }

  private:
    Vec2 acceleration_;  ///< m/s^2
};

static_assert(ForceEffect<TiltedTable>);

template <Scheme kScheme, class Set>
ShotTrace simulate_with(const Scene& scene) {
    Workspace workspace;
    ShotTrace trace;
    ShotRun run(scene, 30, workspace, trace);
    SteppingMemory memory;
    const Set effects(scene);
    SteppingSolver<Set, kScheme>(effects, run, memory).solve();
    return trace;
}

Scene along_the_table() {
    Scene scene = testing::scene_of({0, 0.3}, {0.5, 0});
    scene.table.rails = false;
    scene.solver.hz = 1000;
    scene.limits.time = 2;
    return scene;
}

TEST(UserEffect, BallOnATiltedTableWithoutClothRunsOnAParabola) {
    const Scene scene = along_the_table();
    const double fall = 0.001 * scene.gravity * 2 * 2 / 2;
    for (const ShotTrace& trace :
         {simulate_with<Scheme::kEuler, EffectSet<TiltedTable>>(scene),
          simulate_with<Scheme::kSemiImplicit, EffectSet<TiltedTable>>(scene)}) {
        EXPECT_NEAR(1, testing::final_place(trace, 0).x, 1e-12);
        EXPECT_NEAR(0.3 - fall, testing::final_place(trace, 0).y, fall / 1000);
        EXPECT_NEAR(-0.001 * scene.gravity * 2, testing::final_velocity(trace, 0).y, 1e-12);
    }
}

TEST(UserEffect, IsAForceThatSolversInClosedFormCanRefuse) {
    Scene scene = along_the_table();
    using Tilted = EffectSet<Sliding, TiltedTable>;
    EXPECT_TRUE(Tilted::calls_for_force(scene));
    scene.gravity = 0;
    EXPECT_FALSE(Tilted::calls_for_force(scene));
    EXPECT_FALSE((EffectSet<Sliding, Rolling>::calls_for_force(scene)));
}

TEST(UserEffect, WorksTogetherWithTheLibrarysEffects) {
    Scene scene = along_the_table();
    scene.effects = testing::cloth_effects();
    scene.limits.time = 60;
    const ShotTrace level = simulate(scene);
    const auto tilted =
        simulate_with<Scheme::kEuler, EffectSet<Sliding, Rolling, Rails, TiltedTable>>(scene);
    EXPECT_EQ(Outcome::kRest, tilted.outcome);
    EXPECT_EQ(0.3, testing::final_place(level, 0).y);
    EXPECT_LT(testing::final_place(tilted, 0).y, 0.29);
}

}  // namespace
}  // namespace poolhall
