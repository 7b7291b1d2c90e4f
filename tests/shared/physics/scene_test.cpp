#include "shared/physics/scene.hpp"

#include "tests/shared/scenes.hpp"

#include <functional>
#include <gtest/gtest.h>
#include <limits>

namespace poolhall {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kDiameter = 2 * BallSpec{}.radius;

Scene good_scene() {
    Scene scene = testing::scene_of({{-0.5, 0}, {0.5, 0.1}, {0.7, -0.2}});
    scene.effects.linear_drag = LinearDragSpec{};
    scene.strike = Strike{BallIndex{0}, {1, 0}, 2};
    return scene;
}

struct BadScene {
    const char* pointer;
    std::function<void(Scene&)> spoil;
};

void PrintTo(const BadScene& bad, std::ostream* out) {
    *out << bad.pointer;
}

class SceneCheck : public ::testing::TestWithParam<BadScene> {};

TEST_P(SceneCheck, NamesTheFieldThatIsWrong) {
    Scene scene = good_scene();
    ASSERT_FALSE(check(scene));
    GetParam().spoil(scene);
    const auto error = check(scene);
    ASSERT_TRUE(error);
    EXPECT_EQ(GetParam().pointer, error->pointer);
    EXPECT_FALSE(error->reason.empty());
}

const BadScene kBadScenes[] = {
    {"/table/length", [](Scene& s) { s.table.length = kNan; }},
    {"/table/length", [](Scene& s) { s.table.length = -1; }},
    {"/table/width", [](Scene& s) { s.table.width = kInfinity; }},
    {"/table/width", [](Scene& s) { s.table.width = 0; }},
    {"/table", [](Scene& s) { s.table.width = 3.9 * s.ball.radius; }},
    {"/table/pockets",
     [](Scene& s) {
         s.table.rails = false;
         s.table.pockets = PocketModel::kEndGame;
     }},
    {"/ball/radius", [](Scene& s) { s.ball.radius = 0; }},
    {"/ball/mass", [](Scene& s) { s.ball.mass = kNan; }},
    {"/gravity", [](Scene& s) { s.gravity = -9.81; }},
    {"/solver/hz", [](Scene& s) { s.solver.hz = 0; }},
    {"/solver/hz", [](Scene& s) { s.solver.hz = kNan; }},
    {"/effects/rail/e", [](Scene& s) { s.effects.rail.e = 1.0001; }},
    {"/effects/linear_drag/k", [](Scene& s) { s.effects.linear_drag->k = -0.1; }},
    {"/effects/linear_drag/k", [](Scene& s) { s.effects.linear_drag->k = 30; }},
    {"/effects/linear_drag/stop_speed", [](Scene& s) { s.effects.linear_drag->stop_speed = kNan; }},
    {"/limits/time", [](Scene& s) { s.limits.time = 0; }},
    {"/limits/time", [](Scene& s) { s.limits.time = kInfinity; }},
    {"/limits/time",
     [](Scene& s) {
         s.solver.hz = 1e6;
         s.limits.time = 1001;
     }},
    {"/limits/events", [](Scene& s) { s.limits.events = 0; }},
    {"/limits/events", [](Scene& s) { s.limits.events = 10'000'001; }},
    {"/balls", [](Scene& s) { s.balls.resize(kMaxBalls + 1); }},
    {"/balls/1/id", [](Scene& s) { s.balls[1].id.clear(); }},
    {"/balls/1/id", [](Scene& s) { s.balls[1].id = std::string(kMaxIdBytes + 1, 'x'); }},
    {"/balls/2/id", [](Scene& s) { s.balls[2].id = s.balls[0].id; }},
    {"/balls/1/r/0", [](Scene& s) { s.balls[1].state.r.x = kNan; }},
    {"/balls/1/r/2", [](Scene& s) { s.balls[1].state.r.z = 1e200; }},
    {"/balls/1/v/1", [](Scene& s) { s.balls[1].state.v.y = -kInfinity; }},
    {"/balls/1/v/0", [](Scene& s) { s.balls[1].state.v.x = 1e200; }},
    {"/balls/1/w/2", [](Scene& s) { s.balls[1].state.w.z = kNan; }},
    {"/balls/1/r", [](Scene& s) { s.balls[1].state.r.y = 0.61; }},
    {"/balls/2/r", [](Scene& s) { s.balls[2].state.r = s.balls[1].state.r; }},
    {"/balls/2/r",
     [](Scene& s) {
         s.balls[2].state.r = s.balls[1].state.r;
         s.balls[2].state.r.x += kDiameter - 2e-9;
     }},
    {"/strike/ball", [](Scene& s) { s.strike->ball.value = 3; }},
    {"/strike/direction", [](Scene& s) { s.strike->direction = {}; }},
    {"/strike/direction", [](Scene& s) { s.strike->direction.x = kNan; }},
    {"/strike/speed", [](Scene& s) { s.strike->speed = -1; }},
    {"/strike/speed", [](Scene& s) { s.strike->speed = 1e200; }},
};

INSTANTIATE_TEST_SUITE_P(BadScenes, SceneCheck, ::testing::ValuesIn(kBadScenes));

TEST(SceneCheckLimits, TouchingWithinTheToleranceIsAllowed) {
    Scene scene = good_scene();
    scene.balls[2].state.r = scene.balls[1].state.r;
    scene.balls[2].state.r.x += kDiameter - 0.9e-9;
    EXPECT_FALSE(check(scene));
}

TEST(SceneCheckLimits, BallAgainstARailIsAllowed) {
    Scene scene = good_scene();
    const Vec2 edge = inset(scene.table, scene.ball.radius);
    scene.balls[1].state.r = {edge.x, -edge.y, 0};
    EXPECT_FALSE(check(scene));
}

TEST(SceneCheckLimits, EndlessClothHasRoomForAThousandKilometres) {
    Scene scene = good_scene();
    scene.table.rails = false;
    scene.balls[1].state.r = {1e6, -1e6, 0};
    EXPECT_FALSE(check(scene));
}

TEST(SceneCheckLimits, EmptyTableIsAllowed) {
    EXPECT_FALSE(check(Scene{}));
}

TEST(FindBall, FindsByIdOrNothing) {
    const Scene scene = good_scene();
    EXPECT_EQ(BallIndex{2}, find_ball(scene, "2"));
    EXPECT_FALSE(find_ball(scene, "cue"));
}

}  // namespace
}  // namespace poolhall
