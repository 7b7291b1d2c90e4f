// The cases at which engines of this kind fail: grazes, frozen balls, corners, racks, extremes;
// balls without cloth. Those with cloth are in cloth_hard_cases_test.cpp and
// curved_contact_test.cpp.

#include "tests/shared/invariants.hpp"
#include "tests/shared/quad.hpp"
#include "tests/shared/reference.hpp"
#include "tests/shared/scenes.hpp"
#include "tests/shared/solvers.hpp"
#include "tests/shared/traces.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <map>

namespace poolhall {
namespace {

using testing::count;
using testing::events_of;
using testing::final_place;
using testing::final_velocity;

constexpr double kRadius = BallSpec{}.radius;
constexpr double kDiameter = 2 * kRadius;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
const double kRootThree = std::sqrt(3.0);
const Vec2 kEdge = inset(Table{}, kRadius);

Scene endless(Scene scene, double time) {
    scene.table.rails = false;
    scene.limits.time = time;
    return scene;
}

double energy(const ShotTrace& trace) {
    double sum = 0;
    for (const FinalBall& ball : trace.balls)
        sum += dot(xy(ball.state.v), xy(ball.state.v)) / 2;
    return sum;
}

/// A test of one of the solvers: run() simulates by it.
class BySolver : public ::testing::TestWithParam<SolverKind> {
  protected:
    static ShotTrace run(Scene scene, double sample_hz = 0) {
        scene.solver.kind = GetParam();
        return simulate(scene, sample_hz);
    }
};

class HardCase : public BySolver {};

INSTANTIATE_TEST_SUITE_P(Solvers, HardCase, ::testing::ValuesIn(testing::kSweptSolvers),
                         testing::solver_name);

TEST_P(HardCase, GrazeIsAHitAndAnUlpOrTrillionthMoreIsAMiss) {
    for (const double side : {1.0, -1.0}) {
        const double graze = side * kDiameter;
        const std::map<double, bool> offsets{{graze, true},
                                             {std::nextafter(graze, 0), true},
                                             {std::nextafter(graze, side * kInfinity), false},
                                             {graze * (1 - 1e-12), true},
                                             {graze * (1 + 1e-12), false}};
        for (const auto& [offset, hit] : offsets) {
            Scene scene = endless(testing::scene_of({{0, 0}, {1, offset}}), 1);
            scene.balls[0].state.v.x = 3;
            const auto hits = events_of(run(scene), EventKind::kBallBall);
            ASSERT_EQ(hit ? 1U : 0U, hits.size()) << offset;
            if (offset == graze) {
                EXPECT_NEAR(1, hits[0].t * 3, 1e-14);
            }
        }
    }
}

TEST_P(HardCase, GrazeAtTheEndOfATickIsAHit) {
    for (const double speed : {0.7, 1.0, 2.0, 3.0}) {
        for (int k = 1; k < 200; ++k) {
            const double way = 0.05 * k;
            Scene scene = endless(testing::scene_of({{0, 0}, {way, kDiameter}}), 1.1 * way / speed);
            scene.balls[0].state.v.x = speed;
            const auto hits = events_of(run(scene), EventKind::kBallBall);
            ASSERT_EQ(1U, hits.size()) << way << " m at " << speed << " m/s";
            EXPECT_NEAR(1, hits[0].t * speed / way, 1e-13);
        }
    }
}

TEST_P(HardCase, NothingTunnelsAt30MetresASecondAnd30Hertz) {
    const auto one = testing::reference_case("h_extremes", "tunnel_30mps_head");
    Scene scene = endless(testing::scene_of({{0, 0}, {one.input("dp", 0), 0}}), 1);
    scene.balls[0].state.v.x = -one.input("dv", 0);
    const auto hits = events_of(run(scene), EventKind::kBallBall);
    ASSERT_EQ(1U, hits.size());
    EXPECT_NEAR(1, hits[0].t / one.expected("t"), 1e-14);
}

/// x folded between the rails at +-edge, as a frictionless ball goes.
double folded(testing::Quad x, double edge) {
    const testing::Quad period = 4 * testing::Quad{edge};
    const testing::Quad shifted = x + edge;
    const auto turns = static_cast<std::int64_t>(testing::to_double(shifted / period));
    testing::Quad rest = shifted - period * static_cast<testing::Quad>(turns);
    if (rest < 0) rest += period;
    if (rest > period / 2) rest = period - rest;
    return testing::to_double(rest - edge);
}

TEST_P(HardCase, AMillionRailBouncesStayOnTheUnfoldedLine) {
    const auto one = testing::reference_case("d_rail_chain", "1e6");
    const double total = one.input("T");
    const Vec2 v{one.input("vx"), one.input("vy")};
    const Vec2 start{one.input("x0") - kEdge.x, one.input("y0") - kEdge.y};
    Scene scene = testing::scene_of(start, v);
    scene.solver.hz = 1;
    // In ten shots, each from where the one before ended: the trace of a million events is large.
    scene.limits = {total / 10, 200000};
    std::size_t bounces = 0;
    for (int shot = 1; shot <= 10; ++shot) {
        const ShotTrace trace = run(scene);
        ASSERT_EQ(Outcome::kTimeLimit, trace.outcome);
        bounces += count(trace, EventKind::kBallRail);
        scene.balls[0].state = trace.balls[0].state;
        const testing::Quad t = testing::Quad{scene.limits.time} * shot;
        EXPECT_NEAR(folded(start.x + v.x * t, kEdge.x), scene.balls[0].state.r.x, 1e-10);
        EXPECT_NEAR(folded(start.y + v.y * t, kEdge.y), scene.balls[0].state.r.y, 1e-10);
    }
    EXPECT_EQ(one.expect.at("bounces_x").get<std::size_t>() +
                  one.expect.at("bounces_y").get<std::size_t>(),
              bounces);
    EXPECT_EQ(one.expected("vx"), scene.balls[0].state.v.x);
    EXPECT_EQ(one.expected("vy"), scene.balls[0].state.v.y);
}

TEST_P(HardCase, RailChainWithRestitutionAgreesWithTheReference) {
    const auto one = testing::reference_case("d_rail_chain", "e0.9_bounce10");
    Scene scene = testing::scene_of({one.input("x0") - kEdge.x, 0}, {one.input("v"), 0});
    scene.effects.rail = {RailModel::kRestitution, one.input("e")};
    scene.limits.events = one.inputs.at("N").get<std::uint32_t>();
    const ShotTrace trace = run(scene);
    ASSERT_EQ(Outcome::kEventLimit, trace.outcome);
    EXPECT_NEAR(1, trace.events.back().t / one.expected("t_N"), 1e-14);
    EXPECT_NEAR(1, trace.events.back().after[0].v.x / one.expected("v_after"), 1e-15);
}

void expect_last_ball_to_leave(int frozen, SolverKind solver) {
    SCOPED_TRACE(frozen);
    std::vector<Vec2> places{{-0.5, 0}};
    for (int i = 0; i < frozen; ++i)
        places.push_back({0.1 + i * kDiameter, 0});
    Scene scene = endless(testing::scene_of(places), 1);
    scene.balls[0].state.v.x = 2;
    scene.solver.kind = solver;
    const ShotTrace trace = simulate(scene);
    EXPECT_NEAR(2, final_velocity(trace, places.size() - 1).x, 1e-14);
    for (std::size_t i = 0; i + 1 < places.size(); ++i)
        EXPECT_LE(norm(final_velocity(trace, i)), 1e-14) << "ball " << i;
    EXPECT_EQ(places.size() - 1, count(trace, EventKind::kBallBall));
}

TEST_P(HardCase, LastBallOfACradleLeavesAndTheRestStand) {
    for (int frozen = 1; frozen <= 5; ++frozen)
        expect_last_ball_to_leave(frozen, GetParam());
}

TEST_P(HardCase, CueBallIntoTwoTouchingBallsIsAnExactMirrorImage) {
    const double x = 0.3;
    Scene scene = endless(testing::scene_of({{-0.5, 0}, {x, kRadius}, {x, -kRadius}}), 0.5);
    scene.balls[0].state.v.x = 3;
    const ShotTrace trace = run(scene);
    EXPECT_EQ(2U, count(trace, EventKind::kBallBall));
    EXPECT_NEAR(-3.0 / 5, final_velocity(trace, 0).x, 1e-14);
    EXPECT_EQ(0, final_velocity(trace, 0).y);
    EXPECT_NEAR(3 * 2 * kRootThree / 5, norm(final_velocity(trace, 1)), 1e-14);
    EXPECT_EQ(final_velocity(trace, 1).x, final_velocity(trace, 2).x);
    EXPECT_EQ(final_velocity(trace, 1).y, -final_velocity(trace, 2).y);
    EXPECT_EQ(final_place(trace, 1).y, -final_place(trace, 2).y);
}

TEST_P(HardCase, WedgeWithASmallGapGoesOneAfterTheOther) {
    const auto one = testing::reference_case("e_wedge", "split_gap_1e-09");
    const double gap = one.input("gap_over_R") * kRadius;
    const Vec2 north{kDiameter * kRootThree / 2, kRadius};
    const Vec2 south = (1 + gap / kDiameter) * Vec2{north.x, -north.y};
    Scene scene = endless(testing::scene_of({{0, 0}, north, south}), 0.1);
    scene.balls[0].state.v.x = one.input("v0", 0);
    const ShotTrace trace = run(scene);
    EXPECT_NEAR(one.expected("limit_v_cue", 0), final_velocity(trace, 0).x, 1e-8);
    EXPECT_NEAR(one.expected("limit_v_cue", 1), final_velocity(trace, 0).y, 1e-8);
}

void expect_sound_break(const Scene& scene, double overlap) {
    ASSERT_FALSE(check(scene));
    const ShotTrace trace = simulate(scene, 30);
    EXPECT_EQ(Outcome::kRest, trace.outcome);
    EXPECT_LT(trace.events.size(), 500U);
    EXPECT_EQ("", testing::broken_invariant(scene, trace, overlap));
}

TEST_P(HardCase, TightRackEndsInFewEventsWithoutOverlapOrGainOfEnergy) {
    const double overlap = GetParam() == SolverKind::kEvent ? 1e-12 : 1e-9;
    for (const double gap : {0.0, 1e-12, 1e-9, 1e-6, 1e-4, 1e-3}) {
        for (const double speed : {0.5, 3.0, 8.0, 12.0, 30.0}) {
            for (const double aside : {0.0, 0.01, -0.037}) {
                SCOPED_TRACE(::testing::Message() << gap << " m, " << speed << " m/s, " << aside);
                Scene scene = testing::break_scene(5, gap, speed);
                scene.effects.linear_drag = LinearDragSpec{};
                scene.strike->direction.y = aside;
                scene.solver.kind = GetParam();
                expect_sound_break(scene, overlap);
            }
        }
    }
}

class AnySolver : public BySolver {};

INSTANTIATE_TEST_SUITE_P(Solvers, AnySolver, ::testing::ValuesIn(testing::kAllSolvers),
                         testing::solver_name);

TEST_P(AnySolver, BallFrozenToARailRollsAlongItWithoutAnEvent) {
    for (const double side : {1.0, -1.0}) {
        for (const bool drag : {true, false}) {
            Scene scene = testing::scene_of({-1, side * kEdge.y}, {2, 0});
            if (drag) scene.effects.linear_drag = LinearDragSpec{};
            scene.limits.time = 1;
            const ShotTrace trace = run(scene);
            EXPECT_EQ(0U, count(trace, EventKind::kBallRail));
            EXPECT_EQ(side * kEdge.y, final_place(trace, 0).y);
            EXPECT_GT(final_place(trace, 0).x, 0);
        }
    }
}

TEST_P(AnySolver, CornerTurnsBothComponents) {
    const auto one = testing::reference_case("f_rail", "corner_e0.8");
    const double d = one.input("d");
    for (const Vec2 side : {Vec2{1, 1}, Vec2{1, -1}, Vec2{-1, 1}, Vec2{-1, -1}}) {
        Scene scene = testing::scene_of({side.x * (kEdge.x - d), side.y * (kEdge.y - d)}, side);
        scene.effects.rail = {RailModel::kRestitution, one.input("e")};
        scene.limits.time = 0.6;
        const ShotTrace trace = run(scene);
        const auto rails = events_of(trace, EventKind::kBallRail);
        ASSERT_EQ(2U, rails.size());
        for (const ShotEvent& event : rails)
            EXPECT_NEAR(one.expected("t"), event.t, 1e-14);
        EXPECT_EQ(one.expected("v_after", 0) * side.x, final_velocity(trace, 0).x);
        EXPECT_EQ(one.expected("v_after", 1) * side.y, final_velocity(trace, 0).y);
    }
}

TEST_P(AnySolver, ExtremeSpeedsAndPlacesGiveDefinedResults) {
    for (const double speed : {5e-324, 1e-300, 1e-150, 1e-9, 30.0, 1e6}) {
        for (const double far : {0.0, 1e6 - 10}) {
            Scene scene = endless(testing::scene_of({{far, far}, {far + 1, far}, {0.5, -3}}), 0.1);
            scene.balls[0].state.v = {speed, speed / 3, 0};
            scene.balls[2].state.v = {0, -speed, 0};
            ASSERT_FALSE(check(scene));
            const ShotTrace trace = run(scene);
            EXPECT_EQ(Outcome::kTimeLimit, trace.outcome);
            for (std::size_t i = 0; i < trace.balls.size(); ++i) {
                EXPECT_TRUE(std::isfinite(norm(final_place(trace, i))));
                EXPECT_FALSE(std::isnan(norm(final_velocity(trace, i))));
            }
        }
    }
}

TEST_P(AnySolver, OverlapWithinTheToleranceNeitherTeleportsNorGainsEnergy) {
    for (const double overlap : {1e-16, 1e-12, 0.9e-9}) {
        for (const double toward : {1.0, -1.0}) {
            Scene scene = endless(testing::scene_of({{0, 0}, {kDiameter - overlap, 0}}), 0.1);
            scene.balls[0].state.v = {toward * 0.7, 0.1, 0};
            ASSERT_FALSE(check(scene));
            const ShotTrace trace = run(scene);
            EXPECT_EQ(toward > 0 ? 1U : 0U, count(trace, EventKind::kBallBall));
            EXPECT_NEAR(0.25, energy(trace), 1e-15);
            EXPECT_NEAR(
                toward * 0.07,
                final_place(trace, toward > 0 ? 1 : 0).x - (toward > 0 ? kDiameter - overlap : 0),
                2e-9);
        }
    }
}

TEST_P(HardCase, OverlapThatApproachesMeetsAtOnce) {
    Scene scene = endless(testing::scene_of({{0, 0}, {kDiameter - 1e-12, 0}}), 0.1);
    scene.balls[0].state.v.x = 1;
    const auto hits = events_of(run(scene), EventKind::kBallBall);
    ASSERT_EQ(1U, hits.size());
    EXPECT_EQ(0, hits[0].t);
}

TEST_P(HardCase, BallFrozenToARailAndStruckIntoItHasOneEventAtOnce) {
    for (const auto& one : testing::reference_cases("f_rail")) {
        if (one.id.find("frozen_into") == std::string::npos) continue;
        SCOPED_TRACE(one.id);
        Scene scene = testing::scene_of({0, -kEdge.y}, {one.input("v", 0), one.input("v", 1)});
        scene.effects.rail = {RailModel::kRestitution, one.input("e")};
        scene.limits.time = 0.01;
        const auto rails = events_of(run(scene), EventKind::kBallRail);
        ASSERT_EQ(1U, rails.size());
        EXPECT_EQ(0, rails[0].t);
        EXPECT_EQ(one.expected("v_after", 0), rails[0].after[0].v.x);
        EXPECT_EQ(one.expected("v_after", 1), rails[0].after[0].v.y);
    }
}

TEST_P(HardCase, BallThatWouldStopAtContactHitsOrDoesNot) {
    Scene alone = testing::scene_of({{-1, 0}});
    alone.effects.linear_drag = LinearDragSpec{};
    alone.strike = Strike{BallIndex{0}, {1, 0}, 0.5};
    const double stop = final_place(run(alone), 0).x;
    double x = stop + kDiameter;
    for (int ulps = 0; ulps < 4; ++ulps)
        x = std::nextafter(x, -kInfinity);
    for (int ulps = -4; ulps <= 4; ++ulps, x = std::nextafter(x, kInfinity)) {
        Scene scene = testing::scene_of({{-1, 0}, {x, 0}});
        scene.effects = alone.effects;
        scene.strike = alone.strike;
        const ShotTrace trace = run(scene);
        EXPECT_EQ(Outcome::kRest, trace.outcome);
        EXPECT_LE(count(trace, EventKind::kBallBall), 1U);
        // Under linear drag the ball is stopped at a speed, so that a hit at the end still moves
        // the other as far as it would have rolled itself.
        EXPECT_LE(final_place(trace, 1).x - x, 0.0625 / 30 / (1 - 0.98));
        EXPECT_GE(final_place(trace, 1).x - x, 0);
    }
}

TEST_P(HardCase, SlowChaseHasABoundedNumberOfEvents) {
    for (const double faster : {1e-15, 1e-12, 1e-6}) {
        for (const double gap : {0.0, 1e-12, 1e-9}) {
            Scene scene = testing::scene_of({{-1, 0}, {-1 + kDiameter + gap, 0}});
            scene.effects.linear_drag = LinearDragSpec{};
            scene.balls[0].state.v.x = 2 * (1 + faster);
            scene.balls[1].state.v.x = 2;
            const ShotTrace trace = run(scene);
            EXPECT_EQ(Outcome::kRest, trace.outcome);
            EXPECT_LT(trace.events.size(), 12U);
        }
    }
}

TEST_P(HardCase, BallsPressedTogetherAndAgainstARailComeToAnEnd) {
    // A row frozen to the rail, a ball frozen to it that pushes, and another that comes after.
    const std::vector<Vec2> places{{kEdge.x, 0},
                                   {kEdge.x - kDiameter, 0},
                                   {kEdge.x - 2 * kDiameter, 0},
                                   {kEdge.x - 3 * kDiameter, 0},
                                   {kEdge.x - 4.5 * kDiameter, 1e-3}};
    for (const double e : {0.0, 0.5, 1.0}) {
        Scene scene = testing::scene_of(places);
        scene.effects.linear_drag = LinearDragSpec{};
        scene.effects.rail = {RailModel::kRestitution, e};
        scene.balls[3].state.v.x = 1;
        scene.balls[4].state.v.x = 1.5;
        const ShotTrace trace = run(scene);
        EXPECT_EQ(Outcome::kRest, trace.outcome);
        EXPECT_LT(trace.events.size(), 200U) << "e = " << e;
    }
}

TEST_P(HardCase, BallsOfTheSameVelocityNeverMeet) {
    Scene scene = endless(testing::scene_of({{0, 0}, {kDiameter, 0}, {0, kDiameter}}), 5);
    for (SceneBall& ball : scene.balls)
        ball.state.v = {1.1, -0.3, 0};
    EXPECT_EQ(0U, count(run(scene), EventKind::kBallBall));
}

}  // namespace
}  // namespace poolhall
