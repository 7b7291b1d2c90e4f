#include "shared/physics/simulate.hpp"
#include "tests/shared/random.hpp"
#include "tests/shared/scenes.hpp"
#include "tests/shared/solvers.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace poolhall {
namespace {

/// A scene of the original game for each way of calling for its effects or not.
std::vector<Scene> drag_scenes(testing::Random& random) {
    std::vector<Scene> scenes;
    for (int kind = 0; kind < 8; ++kind) {
        Scene scene = testing::random_scene(random, 6, 4);
        if ((kind & 1) != 0) scene.effects.linear_drag.reset();
        if ((kind & 2) != 0) scene.table.rails = false;
        if ((kind & 4) != 0 && scene.table.rails) scene.table.pockets = PocketModel::kEndGame;
        scenes.push_back(scene);
    }
    return scenes;
}

/// A scene of real pool for each way of calling for the effects of its cloth, and some with
/// pockets, other rails, balls in the air.
std::vector<Scene> cloth_scenes(testing::Random& random) {
    std::vector<Scene> scenes;
    for (int kind = 0; kind < 32; ++kind) {
        Scene scene = testing::random_scene(random, 6, 4);
        scene.effects = (kind & 4) != 0 ? testing::cloth_effects() : testing::pool_effects();
        if ((kind & 1) != 0) scene.effects.sliding.reset();
        if ((kind & 2) != 0) scene.effects.rolling.reset();
        if ((kind & 8) != 0) {
            scene.table.pockets = PocketModel::kCircles;
            scene.table.circles = {{"NE", {1.27, 0.635}, 0.1}, {"S", {0, -0.635}, 0.1}};
        }
        if ((kind & 16) != 0) scene.table.pockets = PocketModel::kPool;
        if ((kind & 24) == 24) scene.table.pockets = PocketModel::kEndGame;
        if (kind == 0) scene.effects.airborne = AirborneSpec{};
        scene.strike->offset = 0.5 * random.direction();
        scenes.push_back(scene);
    }
    return scenes;
}

std::vector<Scene> scenes_of_every_kind() {
    testing::Random random(5);
    std::vector<Scene> scenes;
    for (const std::vector<Scene>& some : {drag_scenes(random), cloth_scenes(random)}) {
        for (Scene scene : some) {
            scene.limits = {10, 2000};
            for (const SolverKind solver : testing::kAllSolvers) {
                scene.solver.kind = solver;
                if (!check(scene)) scenes.push_back(scene);
            }
        }
    }
    return scenes;
}

TEST(Kernels, EveryOneThatCoversASceneGivesTheSameTrace) {
    int compared = 0;
    for (const Scene& scene : scenes_of_every_kind()) {
        const ShotTrace chosen = simulate(scene, 30);
        for (const std::string_view name : kernel_names()) {
            ShotTrace trace;
            if (!simulate_by(name, scene, 30, trace)) continue;
            SCOPED_TRACE(std::string(name) + " and " + std::string(chosen.kernel));
            EXPECT_EQ(name, trace.kernel);
            EXPECT_EQ(chosen.hash, trace.hash);
            EXPECT_EQ(chosen.events, trace.events);
            EXPECT_EQ(chosen.samples, trace.samples);
            compared += name != chosen.kernel;
        }
    }
    EXPECT_GT(compared, 200);
}

TEST(Kernels, TheChosenOneIsTheFirstOfTheListThatCoversTheScene) {
    for (const Scene& scene : scenes_of_every_kind()) {
        ShotTrace trace;
        const auto names = kernel_names();
        const auto first = std::find_if(names.begin(), names.end(), [&](std::string_view name) {
            return simulate_by(name, scene, 0, trace);
        });
        ASSERT_NE(names.end(), first);
        EXPECT_EQ(*first, simulate(scene).kernel);
    }
}

TEST(Kernels, OneThatDoesNotCoverTheSceneOrDoesNotExistRefuses) {
    ShotTrace trace;
    trace.hash = 42;
    Scene scene = testing::break_scene(2, 0, 1);
    EXPECT_FALSE(simulate_by("open_cloth", scene, 0, trace));
    EXPECT_FALSE(simulate_by("no_such_kernel", scene, 0, trace));
    EXPECT_EQ(42U, trace.hash);
}

/// The scene without an effect, and with the same effect at a coefficient of zero.
struct AbsentAndZero {
    const char* name;
    void (*zero)(Effects&);
};

TEST(Kernels, AnEffectWithAZeroCoefficientIsAbsent) {
    const std::vector<AbsentAndZero> cases{
        {"linear_drag",
         [](Effects& e) {
             e.linear_drag = LinearDragSpec{0, 0};
         }},
        {"sliding", [](Effects& e) { e.sliding = SlidingSpec{0}; }},
        {"rolling", [](Effects& e) { e.rolling = RollingSpec{0}; }},
        {"spin_decay", [](Effects& e) { e.spin_decay = SpinDecaySpec{0}; }},
        {"restitution",
         [](Effects& e) {
             e.ball_ball.model = BallBallModel::kRestitution;
             e.ball_ball.e = 1;
         }},
        {"friction",
         [](Effects& e) {
             e.ball_ball.model = BallBallModel::kFriction;
             e.ball_ball.e = 1;
             e.ball_ball.mu = 0;
         }},
        {"rail",
         [](Effects& e) {
             e.rail = {RailModel::kRestitution, 1};
         }},
    };
    for (const SolverKind solver : testing::kAllSolvers) {
        for (const AbsentAndZero& one : cases) {
            SCOPED_TRACE(std::string(one.name) + " by " + std::string(name(solver)));
            testing::Random random(6);
            Scene scene = testing::random_scene(random, 8, 3);
            scene.effects.linear_drag.reset();
            scene.limits.time = 5;
            scene.solver.kind = solver;
            scene.balls[0].state.w = {3, 4, 5};
            const ShotTrace absent = simulate(scene);
            one.zero(scene.effects);
            EXPECT_EQ(absent.hash, simulate(scene).hash);
        }
    }
}

}  // namespace
}  // namespace poolhall
