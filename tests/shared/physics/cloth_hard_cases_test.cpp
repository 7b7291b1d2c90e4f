// The hard cases that the cloth makes: balls that slide and roll while they touch others and rails.

#include "tests/shared/invariants.hpp"
#include "tests/shared/scenes.hpp"
#include "tests/shared/solvers.hpp"
#include "tests/shared/traces.hpp"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace poolhall {
namespace {

using testing::count;
using testing::events_of;
using testing::final_place;

constexpr double kRadius = BallSpec{}.radius;
constexpr double kDiameter = 2 * kRadius;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
const Vec2 kEdge = inset(Table{}, kRadius);

class ClothHardCase : public ::testing::TestWithParam<SolverKind> {
  protected:
    /// Balls at rest on a table with cloth and rails.
    static Scene on_cloth(const std::vector<Vec2>& places) {
        Scene scene = testing::scene_of(places);
        scene.effects = testing::cloth_effects();
        scene.solver.kind = GetParam();
        return scene;
    }

    static Vec3 rolling_spin(Vec2 v) { return {-v.y / kRadius, v.x / kRadius, 0}; }

    static double overlap() { return GetParam() == SolverKind::kEvent ? 1e-12 : 1e-9; }

    static void expect_sound(const Scene& scene) {
        const ShotTrace trace = simulate(scene, 30);
        EXPECT_EQ(Outcome::kRest, trace.outcome);
        EXPECT_EQ("", testing::broken_invariant(scene, trace, overlap()));
    }
};

INSTANTIATE_TEST_SUITE_P(Solvers, ClothHardCase, ::testing::ValuesIn(testing::kSweptSolvers),
                         testing::solver_name);

TEST_P(ClothHardCase, BallFrozenToARailRollsOrSlidesAlongItWithoutAnEvent) {
    for (const double side : {1.0, -1.0}) {
        for (const bool rolls : {true, false}) {
            Scene scene = on_cloth({{-1, side * kEdge.y}});
            scene.balls[0].state.v.x = 0.4;
            if (rolls) scene.balls[0].state.w = rolling_spin({0.4, 0});
            const ShotTrace trace = simulate(scene);
            EXPECT_EQ(Outcome::kRest, trace.outcome);
            EXPECT_EQ(0U, count(trace, EventKind::kBallRail));
            EXPECT_EQ(side * kEdge.y, final_place(trace, 0).y);
        }
    }
}

TEST_P(ClothHardCase, BallFrozenToARailAndStruckIntoItHasOneEventAtOnce) {
    for (const double into : {1e-300, 1e-150, 1e-12, 1e-3, 1.0, 30.0}) {
        // Friction first: a semi-implicit step would stop or slow the ball before it arrives.
        if (GetParam() == SolverKind::kSemiImplicit) continue;
        for (const double along : {0.0, 2.0}) {
            SCOPED_TRACE(::testing::Message() << into << " " << along);
            Scene scene = on_cloth({{0, -kEdge.y}});
            scene.balls[0].state.v = {along, -into, 0};
            scene.limits.time = 0.02;
            const ShotTrace trace = simulate(scene);
            const auto rails = events_of(trace, EventKind::kBallRail);
            ASSERT_EQ(1U, rails.size());
            EXPECT_EQ(0, rails[0].t);
            EXPECT_NEAR(1, rails[0].after[0].v.y / (0.85 * into), 1e-15);
            EXPECT_EQ(along, rails[0].after[0].v.x);
            EXPECT_EQ("", testing::broken_invariant(scene, trace, overlap()));
        }
    }
}

TEST_P(ClothHardCase, BallRolledIntoACornerTurnsBothComponents) {
    for (const Vec2 side : {Vec2{1, 1}, Vec2{1, -1}, Vec2{-1, 1}, Vec2{-1, -1}}) {
        Scene scene = on_cloth({{side.x * (kEdge.x - 0.25), side.y * (kEdge.y - 0.25)}});
        set_xy(scene.balls[0].state.v, side);
        scene.balls[0].state.w = rolling_spin(side);
        scene.limits.events = 2;
        const ShotTrace trace = simulate(scene);
        const auto rails = events_of(trace, EventKind::kBallRail);
        ASSERT_EQ(2U, rails.size());
        EXPECT_NEAR(rails[0].t, rails[1].t, 1e-14);
        EXPECT_NEAR(-side.x * 0.85 * std::abs(rails[0].before[0].v.x), rails[1].after[0].v.x,
                    1e-14);
        EXPECT_NEAR(-side.y * 0.85 * std::abs(rails[0].before[0].v.y), rails[1].after[0].v.y,
                    1e-14);
    }
}

TEST_P(ClothHardCase, LastBallOfACradleLeavesAndTheRestStand) {
    for (std::size_t frozen = 1; frozen <= 5; ++frozen) {
        SCOPED_TRACE(frozen);
        // The cue ball is frozen to them too: on its way it would begin to roll, and press.
        std::vector<Vec2> places{{-kDiameter, 0}};
        for (std::size_t i = 0; i < frozen; ++i)
            places.push_back({static_cast<double>(i) * kDiameter, 0});
        Scene scene = on_cloth(places);
        scene.effects.ball_ball.model = BallBallModel::kElastic;
        scene.balls[0].state.v.x = 2;
        const ShotTrace trace = simulate(scene);
        std::vector<double> speeds(frozen + 1);
        for (const ShotEvent& event : events_of(trace, EventKind::kBallBall)) {
            for (std::size_t i = 0; i < 2; ++i)
                speeds[event.balls[i].value] = event.after[i].v.x;
            if (event.balls[1].value == frozen) break;
        }
        const double slowed = GetParam() == SolverKind::kSemiImplicit ? 0.2 * 9.81 / 30 : 0;
        EXPECT_NEAR(2 - slowed, speeds[frozen], 1e-14);
        for (std::size_t i = 0; i < frozen; ++i)
            EXPECT_NEAR(0, speeds[i], 1e-14) << "ball " << i;
    }
}

TEST_P(ClothHardCase, BallThatWouldStopAtContactHitsOrDoesNot) {
    Scene alone = on_cloth({{0, 0}});
    alone.balls[0].state.v.x = 0.3132091952673163;
    alone.balls[0].state.w = rolling_spin({0.3132091952673163, 0});
    const double stop = final_place(simulate(alone), 0).x;
    for (int ulps = -4; ulps <= 4; ++ulps) {
        SCOPED_TRACE(ulps);
        Scene scene = alone;
        double x = stop + kDiameter;
        for (int i = 0; i < std::abs(ulps); ++i)
            x = std::nextafter(x, ulps < 0 ? -kInfinity : kInfinity);
        scene.balls.push_back({"object", {{x, 0, 0}, {}, {}}});
        const ShotTrace trace = simulate(scene);
        EXPECT_EQ(Outcome::kRest, trace.outcome);
        EXPECT_LE(count(trace, EventKind::kBallBall), 1U);
        // In a tick of an Euler step the last velocity is a whole tick's deceleration.
        const bool by_ticks = GetParam() != SolverKind::kEvent;
        EXPECT_NEAR(x, final_place(trace, 1).x, by_ticks ? 1e-4 : 1e-12);
    }
}

TEST_P(ClothHardCase, SlowChaseHasAtMostSixtyEvents) {
    for (const double faster : {1e-15, 1e-12, 1e-9, 1e-6, 1e-3}) {
        for (const double gap : {0.0, 1e-12, 1e-9, 1e-6}) {
            SCOPED_TRACE(::testing::Message() << faster << " " << gap);
            Scene scene = on_cloth({{-1, 0}, {-1 + kDiameter + gap, 0}});
            const std::array speeds{0.3 * (1 + faster), 0.3};
            for (std::size_t i = 0; i < 2; ++i) {
                scene.balls[i].state.v.x = speeds[i];
                scene.balls[i].state.w = rolling_spin({speeds[i], 0});
            }
            const ShotTrace trace = simulate(scene, 30);
            EXPECT_EQ(Outcome::kRest, trace.outcome);
            EXPECT_LE(trace.events.size(), 60U);
            EXPECT_EQ("", testing::broken_invariant(scene, trace, overlap()));
        }
    }
}

TEST_P(ClothHardCase, TwoBallsThatSpinIntoEachOtherComeToRest) {
    for (const double spin : {10.0, 100.0, 300.0}) {
        for (const double gap : {0.0, 1e-6, 1e-2}) {
            SCOPED_TRACE(::testing::Message() << spin << " " << gap);
            Scene scene = on_cloth({{-kRadius - gap / 2, 0}, {kRadius + gap / 2, 0}});
            scene.balls[0].state.w.y = spin;
            scene.balls[1].state.w.y = -spin;
            expect_sound(scene);
        }
    }
}

TEST_P(ClothHardCase, BallsPressedTogetherAndAgainstARailComeToAnEnd) {
    const std::vector<Vec2> places{{kEdge.x, 0},
                                   {kEdge.x - kDiameter, 0},
                                   {kEdge.x - 2 * kDiameter, 0},
                                   {kEdge.x - 3 * kDiameter, 0},
                                   {kEdge.x - 4.5 * kDiameter, 1e-3}};
    for (const double e : {0.0, 0.5, 1.0}) {
        SCOPED_TRACE(e);
        Scene scene = on_cloth(places);
        scene.effects.rail.e = e;
        scene.balls[3].state.v.x = 1;
        scene.balls[3].state.w.y = 100;
        scene.balls[4].state.v.x = 1.5;
        scene.balls[4].state.w.y = 1.5 / kRadius;
        expect_sound(scene);
    }
}

TEST_P(ClothHardCase, OverlapAtTheStartNeitherTeleportsNorGainsEnergyNorHangs) {
    for (const double depth : {1e-16, 1e-12, 0.9e-9, 1e-6, 1e-3}) {
        for (const double toward : {1.0, -1.0}) {
            SCOPED_TRACE(::testing::Message() << depth << " " << toward);
            Scene scene = on_cloth({{0, 0}, {kDiameter - depth, 0}});
            scene.balls[0].state.v = {toward * 0.7, 0.1, 0};
            EXPECT_EQ(depth > kTouchTolerance, check(scene).has_value());
            const ShotTrace trace = simulate(scene, 30);
            EXPECT_EQ(Outcome::kRest, trace.outcome);
            const auto hits = events_of(trace, EventKind::kBallBall);
            EXPECT_EQ(toward > 0, !hits.empty());
            if (!hits.empty()) {
                EXPECT_EQ(0, hits[0].t);
            }
            EXPECT_EQ("", testing::broken_invariant(scene, trace, depth + overlap()));
            EXPECT_EQ(kDiameter - depth, trace.sample(0, 1).x);
        }
    }
}

TEST_P(ClothHardCase, CoincidentBallsAreRefusedAndWouldEndAllTheSame) {
    for (const double speed : {0.0, 1.0}) {
        Scene scene = on_cloth({{0, 0}, {0, 0}});
        scene.balls[0].state.v.x = speed;
        ASSERT_TRUE(check(scene));
        EXPECT_EQ("/balls/1/r", check(scene)->pointer);
        const ShotTrace trace = simulate(scene);
        EXPECT_NE(Outcome::kEventLimit, trace.outcome);
        for (const FinalBall& ball : trace.balls)
            EXPECT_TRUE(std::isfinite(norm(xy(ball.state.r)))) << speed;
    }
}

void expect_finite(const ShotTrace& trace) {
    for (const FinalBall& ball : trace.balls) {
        EXPECT_TRUE(std::isfinite(norm(ball.state.r)));
        EXPECT_TRUE(std::isfinite(norm(ball.state.v)));
        EXPECT_TRUE(std::isfinite(norm(ball.state.w)));
    }
}

TEST_P(ClothHardCase, BallThatStartsInAPocketDropsWhicheverWayItGoes) {
    for (const Vec2 v : {Vec2{1, 0.3}, Vec2{-1, -0.3}, Vec2{0, 0.01}}) {
        for (const bool rolls : {true, false}) {
            Scene scene = on_cloth({{0.03, 0}});
            set_xy(scene.balls[0].state.v, v);
            if (rolls) scene.balls[0].state.w = rolling_spin(v);
            scene.table.pockets = PocketModel::kCircles;
            scene.table.circles = {{"hole", {0, 0}, 0.06}};
            const auto captures = events_of(simulate(scene), EventKind::kBallPocket);
            ASSERT_EQ(1U, captures.size());
            EXPECT_EQ(0, captures[0].t);
        }
    }
}

TEST_P(ClothHardCase, BallThatStartsInTwoPocketsDropsIntoTheFirst) {
    Scene scene = on_cloth({{0, 0}});
    set_xy(scene.balls[0].state.v, {1, 0});
    scene.table.pockets = PocketModel::kCircles;
    scene.table.circles = {{"far", {1, 0}, 0.1}, {"first", {0.02, 0}, 0.06}, {"second", {}, 0.06}};
    EXPECT_EQ(Pocket{1}, simulate(scene).balls[0].pocket);
}

TEST_P(ClothHardCase, BallThatComesUpUnderOneThatFliesOnHitsIt) {
    // Seen from above they part.
    Scene scene = on_cloth({{0, 0}, {0.02, 0}});
    scene.effects.airborne = AirborneSpec{};
    scene.balls[0].state.r.z = 0.06;
    scene.balls[0].state.v = {-0.1, 0, 0};
    scene.balls[1].state.v = {0.1, 0, 1};
    scene.solver.hz = 480;
    const auto hits = events_of(simulate(scene), EventKind::kBallBall);
    ASSERT_LT(0U, hits.size());
    // Both fall alike: |(0.02 + 0.2 t, -0.06 + t)| is a diameter.
    const double gap = 0.02 * 0.02 + 0.06 * 0.06 - kDiameter * kDiameter;
    EXPECT_NEAR((0.056 - std::sqrt(0.056 * 0.056 - 1.04 * gap)) / 1.04, hits[0].t, 1e-12);
}

TEST_P(ClothHardCase, ShotGoesOnWhenABallHasLeftTheTable) {
    Scene scene = on_cloth({{1, 0}, {0, 0}, {-1, 0}});
    scene.effects.airborne = AirborneSpec{};
    scene.balls[0].state.v = {2, 0, 1};
    scene.balls[1].state.v = {0.1, 1, 0};
    scene.solver.hz = 240;
    const ShotTrace trace = simulate(scene, 30);
    EXPECT_EQ(Outcome::kRest, trace.outcome);
    EXPECT_EQ(Motion::kOffTable, trace.balls[0].motion);
    EXPECT_EQ(1U, count(trace, EventKind::kOffTable));
    EXPECT_EQ(Motion::kStationary, trace.balls[1].motion);
    EXPECT_LT(0U, count(trace, EventKind::kRollToRest));
    EXPECT_EQ("", testing::broken_invariant(scene, trace, overlap()));
}

TEST_P(ClothHardCase, ShotEndsWhenItsOnlyBallHasLeftTheTable) {
    Scene scene = on_cloth({{1, 0}});
    scene.effects.airborne = AirborneSpec{};
    scene.balls[0].state.v = {2, 0, 1};
    scene.solver.hz = 240;
    const ShotTrace trace = simulate(scene);
    EXPECT_EQ(Outcome::kRest, trace.outcome);
    ASSERT_EQ(1U, trace.events.size());
    EXPECT_EQ(EventKind::kOffTable, trace.events[0].kind);
}

TEST_P(ClothHardCase, BallThatComesDownBehindTheMiddleOfAPocketDrops) {
    constexpr double kWay = 0.5;  // m, of the flight
    Scene scene = on_cloth({{0, 0}});
    scene.effects.airborne = AirborneSpec{0};
    scene.balls[0].state.v = {1, 0, kWay * scene.gravity / 2};
    scene.table.pockets = PocketModel::kCircles;
    scene.table.circles = {{"hole", {kWay - 0.04, 0}, 0.06}};
    scene.solver.hz = 240;
    const ShotTrace trace = simulate(scene);
    EXPECT_EQ(Motion::kPocketed, trace.balls[0].motion);
    EXPECT_NEAR(kWay, final_place(trace, 0).x, 0.01);
}

TEST_P(ClothHardCase, ExtremeSpeedsAndPlacesGiveDefinedResults) {
    for (const double speed : {5e-324, 1e-300, 1e-150, 1e-9, 30.0, 1e6}) {
        for (const double far : {0.0, 1e6 - 10}) {
            for (const double spin : {0.0, 5e-324, 1e-300, 1e-9, 1e9}) {
                SCOPED_TRACE(::testing::Message() << speed << " " << far << " " << spin);
                Scene scene = on_cloth({{far, far}, {far + 1, far}, {0.5, -3}});
                scene.table.rails = false;
                scene.limits.time = 0.1;
                scene.balls[0].state.v = {speed, speed / 3, 0};
                scene.balls[0].state.w = {spin, -spin / 2, spin};
                scene.balls[2].state.v = {0, -speed, 0};
                ASSERT_FALSE(check(scene));
                const ShotTrace trace = simulate(scene);
                EXPECT_NE(Outcome::kStalled, trace.outcome);
                expect_finite(trace);
            }
        }
    }
}

}  // namespace
}  // namespace poolhall
