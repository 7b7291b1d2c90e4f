#include "shared/physics/scene/trace.hpp"
#include "tests/shared/scene_leaves.hpp"
#include "tests/shared/scenes.hpp"

#include <gtest/gtest.h>
#include <set>

namespace poolhall {
namespace {

TEST(HashOfScene, ChangesWithEveryFieldButTheScenesName) {
    const std::uint64_t whole = hash_of(testing::whole_scene());
    ASSERT_FALSE(check(testing::whole_scene())) << check(testing::whole_scene())->pointer;
    std::set<std::string> seen;
    testing::for_each_changed_leaf([&](const std::string& pointer, const Scene& scene) {
        seen.insert(pointer);
        EXPECT_EQ(pointer == "/id", hash_of(scene) == whole) << pointer;
    });
    // One of each kind, to see that the walk gets everywhere.
    for (const char* pointer : {"/table/rails",
                                "/table/pockets/1/y",
                                "/ball/mass",
                                "/gravity",
                                "/effects/sliding/mu",
                                "/effects/airborne",
                                "/effects/ball_ball/friction_by_speed/c",
                                "/effects/rail/model",
                                "/solver/kind",
                                "/balls/0/w/2",
                                "/balls/1/radius",
                                "/balls",
                                "/limits/events",
                                "/strike/ball",
                                "/strike/offset/1",
                                "/strike/end_mass_ratio",
                                "/strike/cue/e",
                                "/strike/cue",
                                "/strike",
                                "/table/mouths/corner/jaw_radius",
                                "/table/mouths",
                                "/table/nose_height",
                                "/effects/rail/e_by_speed/softening"})
        EXPECT_TRUE(seen.contains(pointer)) << pointer;
}

TEST(HashOfScene, IsThatOfTheSizeABallHasWhetherItsOwnOrThatOfAll) {
    Scene scene = testing::whole_scene();
    scene.balls[0].radius.reset();
    Scene same = scene;
    same.balls[0].radius = scene.ball.radius;
    EXPECT_EQ(hash_of(scene), hash_of(same));
}

/// Of every scene in a log: a change of a list must leave them.
TEST(HashOfScene, KeepsTheValuesOfScenesThatAreStored) {
    EXPECT_EQ("42e8d314f3ed6237", to_hex(hash_of(Scene{})));
    Scene scene;
    scene.balls = {{"cue", {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}},
                   {"8", {{.1, .2, .3}, {.4, .5, .6}, {.7, .8, .9}}, 0.03, 0.2}};
    EXPECT_EQ("d7264164945159be", to_hex(hash_of(scene)));
    scene.effects.linear_drag = LinearDragSpec{0.5, 0.1};
    scene.effects.sliding = SlidingSpec{0.3};
    scene.effects.rolling = RollingSpec{0.02};
    scene.effects.spin_decay = SpinDecaySpec{0.04};
    EXPECT_EQ("8b534a673e3bb4ac", to_hex(hash_of(scene)));
    scene.effects.airborne = AirborneSpec{0.6};
    scene.effects.ball_ball = {BallBallModel::kFriction, 0.9, 0.06, FrictionBySpeed{1, 2, 3}, 2e-4};
    scene.effects.rail = {RailModel::kHan2005, 0.8, 0.3, 0.04};
    EXPECT_EQ("d53416662c01bb49", to_hex(hash_of(scene)));
    scene.solver = {SolverKind::kEvent, 120};
    scene.limits = {10, 77};
    scene.strike = Strike{BallIndex{1}, {0.3, 0.4}, 5, {0.1, 0.2}, 0.5, 0.03};
    EXPECT_EQ("49da6e8fe3040a33", to_hex(hash_of(scene)));
    scene.table.rails = false;
    scene.table.pockets = PocketModel::kCircles;
    scene.table.circles = {{"NE", {1, 2}, 0.1}, {"W", {-1, -2}, 0.2}};
    scene.ball = {0.03, 0.2};
    scene.gravity = 9.7;
    EXPECT_EQ("56f191c3045d40ab", to_hex(hash_of(scene)));
}

}  // namespace
}  // namespace poolhall
