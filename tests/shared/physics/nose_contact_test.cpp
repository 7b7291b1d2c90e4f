#include "shared/physics/check.hpp"
#include "shared/physics/effects/presets.hpp"
#include "shared/physics/simulate.hpp"

#include <cmath>
#include <gtest/gtest.h>

// Rails that are touched where the nose is.
namespace poolhall {
namespace {

constexpr double kRadius = 0.028575;
constexpr double kNoseHeight = 1.27 * kRadius;

/// A ball that rolls straight at the east rail.
Scene square_hit(double radius) {
    Scene scene;
    scene.effects = preset_value(EffectsPreset::kWorsted);
    scene.effects.airborne.reset();
    scene.table.nose_height = scene.effects.rail.nose_height;
    scene.solver.kind = SolverKind::kEvent;
    scene.ball.radius = radius;
    scene.balls = {{"cue", {}}};
    scene.strike = Strike{BallIndex{0}, {1, 0}, 2};
    return scene;
}

double first_rail_at(const ShotTrace& trace) {
    for (const ShotEvent& event : trace.events) {
        if (event.kind == EventKind::kBallRail) return event.after[0].r.x;
    }
    return 0;
}

TEST(NoseContact, IsNearerToTheNoseThanTheRadius) {
    Table table;
    EXPECT_EQ(kRadius, rail_reach(table, kRadius));
    table.nose_height = kNoseHeight;
    EXPECT_NEAR(0.027514, rail_reach(table, kRadius), 1e-6);
    EXPECT_NEAR(kRadius * std::cos(std::asin(0.27)), rail_reach(table, kRadius), 1e-15);
}

TEST(NoseContact, HoldsForEachBallsOwnRadiusAndEverySolver) {
    for (const double radius : {0.02625, kRadius, 0.03015}) {
        Scene scene = square_hit(radius);
        const double reach = rail_reach(scene.table, radius);
        for (const SolverSpec solver :
             {SolverSpec{SolverKind::kEvent}, SolverSpec{SolverKind::kEuler, 120},
              SolverSpec{SolverKind::kSemiImplicit, 120}, SolverSpec{SolverKind::kExactArc, 30},
              SolverSpec{SolverKind::kOverlap, 1000}}) {
            scene.solver = solver;
            ASSERT_FALSE(check(scene));
            EXPECT_NEAR(1.27 - reach, first_rail_at(simulate(scene)),
                        solver.kind == SolverKind::kOverlap ? 1e-3 : 1e-12)
                << name(solver.kind) << " " << radius;
        }
    }
}

TEST(NoseContact, HoldsForTheLinesOfMouthsToo) {
    Scene scene = square_hit(kRadius);
    scene.table.pockets = PocketModel::kPool;
    EXPECT_NEAR(1.27 - rail_reach(scene.table, kRadius), first_rail_at(simulate(scene)), 1e-12);
}

TEST(NoseContact, LetsABallLieAsNearToARailAsItTouches) {
    Scene scene = square_hit(kRadius);
    scene.strike.reset();
    scene.balls[0].state.r = {1.27 - 0.0276, 0, 0};
    EXPECT_FALSE(check(scene));
    scene.table.nose_height.reset();
    EXPECT_TRUE(check(scene));
    scene.table.nose_height = kNoseHeight;
    scene.balls[0].state.r = {1.27 - 0.0275, 0, 0};
    EXPECT_TRUE(check(scene));
}

TEST(NoseContact, IsRefusedAboveABallAndWhereTheRailHasAnotherNose) {
    Scene scene = square_hit(kRadius);
    scene.table.nose_height = 0.036576;
    EXPECT_EQ("/table/nose_height", check(scene)->pointer);
    scene.effects.rail.model = RailModel::kRestitution;
    EXPECT_FALSE(check(scene)) << "a model that knows none";
    scene.table.nose_height = 2 * kRadius;
    EXPECT_EQ("/table/nose_height", check(scene)->pointer);
}

}  // namespace
}  // namespace poolhall
