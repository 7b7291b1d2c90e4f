#include "shared/physics/check.hpp"
#include "tests/shared/scenes.hpp"

#include <array>
#include <cmath>
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

void put_circles(Scene& scene, const std::vector<PocketCircle>& circles) {
    scene.table.pockets = PocketModel::kCircles;
    scene.table.circles = circles;
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

const auto kBadScenes = std::to_array<BadScene>({
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
    {"/balls/1/r/2", [](Scene& s) { s.balls[1].state.r.z = 0.1; }},
    {"/balls/1/v/2", [](Scene& s) { s.balls[1].state.v.z = 0.1; }},
    {"/balls/1/radius", [](Scene& s) { s.balls[1].radius = 0; }},
    {"/balls/1/radius", [](Scene& s) { s.balls[1].radius = kNan; }},
    {"/balls/1/mass", [](Scene& s) { s.balls[1].mass = -1; }},
    {"/balls/1/r",
     [](Scene& s) {
         s.balls[1].state.r.x = 1.24;
         s.balls[1].radius = 0.031;
     }},
    {"/strike/ball", [](Scene& s) { s.strike->ball.value = 3; }},
    {"/strike/direction", [](Scene& s) { s.strike->direction = {}; }},
    {"/strike/direction", [](Scene& s) { s.strike->direction.x = kNan; }},
    {"/strike/speed", [](Scene& s) { s.strike->speed = -1; }},
    {"/strike/speed", [](Scene& s) { s.strike->speed = 1e200; }},
    {"/strike/offset",
     [](Scene& s) {
         s.strike->offset = {0.6, -0.8};
     }},
    {"/strike/offset",
     [](Scene& s) {
         s.strike->offset = {kNan, 0};
     }},
    {"/strike/elevation", [](Scene& s) { s.strike->elevation = -0.1; }},
    {"/strike/elevation", [](Scene& s) { s.strike->elevation = kInfinity; }},
    {"/strike/end_mass_ratio", [](Scene& s) { s.strike->end_mass_ratio = 1.1; }},
    {"/effects/sliding/mu", [](Scene& s) { s.effects.sliding = SlidingSpec{-0.1}; }},
    {"/effects/rolling/mu", [](Scene& s) { s.effects.rolling = RollingSpec{kNan}; }},
    {"/effects/spin_decay/mu", [](Scene& s) { s.effects.spin_decay = SpinDecaySpec{11}; }},
    {"/effects/airborne/e_slate", [](Scene& s) { s.effects.airborne = AirborneSpec{1.1}; }},
    {"/effects/ball_ball/e", [](Scene& s) { s.effects.ball_ball.e = -0.1; }},
    {"/effects/ball_ball/mu", [](Scene& s) { s.effects.ball_ball.mu = kInfinity; }},
    {"/effects/ball_ball/min_separation",
     [](Scene& s) { s.effects.ball_ball.min_separation = -1e-4; }},
    {"/effects/ball_ball/friction_by_speed/b",
     [](Scene& s) {
         s.effects.ball_ball.friction_by_speed = FrictionBySpeed{0, -1, 1};
     }},
    {"/effects/rail/mu", [](Scene& s) { s.effects.rail.mu = -1; }},
    {"/effects/rail/nose_height", [](Scene& s) { s.effects.rail.nose_height = 0; }},
    {"/effects/rail/nose_height",
     [](Scene& s) {
         s.effects.rail = {RailModel::kHan2005, 0.85};
         s.balls[2].radius = 0.018;
     }},
    {"/solver/kind",
     [](Scene& s) {
         s.effects.rolling = RollingSpec{};
         s.solver.kind = SolverKind::kEvent;
     }},
    {"/solver/kind",
     [](Scene& s) {
         s.effects.sliding = SlidingSpec{};
         s.solver.kind = SolverKind::kExactArc;
     }},
    {"/solver/kind",
     [](Scene& s) {
         s.table.pockets = PocketModel::kPool;
         s.solver.kind = SolverKind::kOverlap;
     }},
    {"/solver/kind",
     [](Scene& s) {
         s.effects.airborne = AirborneSpec{};
         s.solver.kind = SolverKind::kOverlap;
     }},
    {"/table/pockets",
     [](Scene& s) {
         s.table.rails = false;
         s.table.pockets = PocketModel::kPool;
     }},
    {"/table",
     [](Scene& s) {
         s.balls.resize(1);
         s.balls[0].state.r = {};
         s.table.length = 0.3;
         s.table.width = 0.2;
         s.table.pockets = PocketModel::kPool;
     }},
    {"/ball/radius",
     [](Scene& s) {
         s.ball.radius = 0.053;
         s.table.pockets = PocketModel::kPool;
     }},
    {"/balls/2/radius",
     [](Scene& s) {
         s.balls[2].radius = 0.053;
         s.table.pockets = PocketModel::kPool;
     }},
    {"/balls/2/r",
     [](Scene& s) {
         s.balls[2].state.r = {1.26, 0.63, 0};
         s.table.pockets = PocketModel::kPool;
     }},
    {"/table/pockets/0/radius",
     [](Scene& s) {
         put_circles(s, {{"a", {1, 0}, 0}});
     }},
    {"/table/pockets/0/x",
     [](Scene& s) {
         put_circles(s, {{"a", {kNan, 0}, 0.1}});
     }},
    {"/table/pockets/1/y",
     [](Scene& s) {
         put_circles(s, {{"a", {}, 1}, {"b", {0, 1e9}, 1}});
     }},
    {"/table/pockets/1/id",
     [](Scene& s) {
         put_circles(s, {{"a", {}, 1}, {"a", {1, 0}, 1}});
     }},
    {"/table/pockets/0/id",
     [](Scene& s) {
         put_circles(s, {{"", {}, 1}});
     }},
    {"/table/pockets",
     [](Scene& s) { put_circles(s, std::vector<PocketCircle>(kMaxPocketCircles + 1)); }},
});

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

TEST(SceneCheckLimits, AirborneBallsMayBeAboveOthers) {
    Scene scene = good_scene();
    scene.effects.airborne = AirborneSpec{};
    scene.balls[2].state.r = scene.balls[1].state.r;
    scene.balls[2].state.r.z = kDiameter;
    EXPECT_FALSE(check(scene));
    scene.balls[2].state.r.z = 0.99 * kDiameter;
    ASSERT_TRUE(check(scene));
    EXPECT_EQ(check(scene)->pointer, "/balls/2/r");
    scene.balls[2].state.r.z = -0.1;
    EXPECT_EQ(check(scene)->pointer, "/balls/2/r/2");
}

TEST(SceneCheckLimits, BallsOfTwoSizesTouchBesideTheirEquators) {
    Scene scene = good_scene();
    scene.balls[2].radius = 0.02;
    scene.balls[2].state.r = scene.balls[1].state.r;
    const double touching = 2 * std::sqrt(0.02 * scene.ball.radius);
    scene.balls[2].state.r.x += touching;
    EXPECT_FALSE(check(scene));
    scene.balls[2].state.r.x -= 1e-8;
    EXPECT_TRUE(check(scene));
}

TEST(SceneCheckLimits, CoefficientsOfZeroHaveAClosedForm) {
    Scene scene = good_scene();
    scene.solver.kind = SolverKind::kEvent;
    scene.effects.sliding = SlidingSpec{0};
    scene.effects.rolling = RollingSpec{0};
    EXPECT_FALSE(check(scene));
    scene.effects.rolling->mu = 0.01;
    EXPECT_TRUE(check(scene));
    scene.effects.linear_drag->k = 0;
    EXPECT_FALSE(check(scene));
}

TEST(SceneCheckLimits, RatesBoundOnlyTheSolversThatHaveTicks) {
    Scene scene = good_scene();
    scene.limits.time = 1e6;
    scene.solver.hz = 2000;
    EXPECT_EQ(check(scene)->pointer, "/limits/time");
    scene.solver.kind = SolverKind::kEvent;
    EXPECT_FALSE(check(scene));
}

TEST(SceneCheckLimits, CirclesNeedNoRails) {
    Scene scene = good_scene();
    scene.table.rails = false;
    put_circles(scene, {{"a", {2, 2}, 0.1}});
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
