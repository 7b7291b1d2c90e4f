// Contacts of balls that decelerate or run on curves, by the event solver: right verdicts and times
// to the last digits, near grazing and near double roots too.

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
using testing::Quad;

constexpr double kRadius = BallSpec{}.radius;
constexpr double kDiameter = 2 * kRadius;
constexpr double kRolling = 0.01 * 9.81;  ///< m/s^2
constexpr double kSliding = 0.2 * 9.81;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Ball 0 on an endless cloth, impacts without a least separation speed.
Scene on_endless_cloth(const std::vector<Vec2>& places, Vec2 v) {
    Scene scene = testing::scene_of(places);
    set_xy(scene.balls[0].state.v, v);
    scene.table.rails = false;
    scene.effects = testing::cloth_effects();
    scene.effects.ball_ball.model = BallBallModel::kElastic;
    scene.effects.ball_ball.min_separation = 0;
    scene.solver.kind = SolverKind::kEvent;
    return scene;
}

/// The same with ball 0 rolling.
Scene rolling(const std::vector<Vec2>& places, Vec2 v) {
    Scene scene = on_endless_cloth(places, v);
    scene.balls[0].state.w = {-v.y / kRadius, v.x / kRadius, 0};
    return scene;
}

Vec2 expected_vector(const testing::ReferenceCase& one, const char* name) {
    return {one.expected(name, 0), one.expected(name, 1)};
}

TEST(CurvedContact, RollingBallMeetsARestingOneAsTheReferenceSays) {
    int hits = 0;
    for (const auto& one : testing::reference_cases("b_toi_decel")) {
        if (one.inputs.at("b").is_string()) continue;  // no double
        SCOPED_TRACE(one.id);
        const double speed = one.input("v0");
        const Scene scene = rolling({{0, 0}, {one.input("D"), one.input("b")}}, {speed, 0});
        const auto found = events_of(simulate(scene), EventKind::kBallBall);
        const bool hit = one.expect.at("hit").get<bool>();
        ASSERT_EQ(hit ? 1U : 0U, found.size());
        if (!hit) continue;
        ++hits;
        EXPECT_NEAR(1, found[0].t / one.expected("t"), 1e-14);
        // The normal is made of places that are rounded to 1e-16 m.
        EXPECT_LE(norm(xy(found[0].after[0].v) - expected_vector(one, "v_cue")), 2e-14 * speed);
        EXPECT_LE(norm(xy(found[0].after[1].v) - expected_vector(one, "v_obj")), 2e-14 * speed);
    }
    EXPECT_GE(hits, 10);
}

TEST(CurvedContact, NearDoubleRootIsAHitAndJustBesideItAMiss) {
    for (const char* id : {"near_double_root", "near_double_root_miss"}) {
        SCOPED_TRACE(id);
        const auto one = testing::reference_case("b_toi_quartic", id);
        Scene scene = rolling({{0, 0}, {one.input("dp", 0), one.input("dp", 1)}},
                              {-one.input("dv", 0), -one.input("dv", 1)});
        scene.effects.rolling->mu = one.input("da", 0) / scene.gravity;
        const auto found = events_of(simulate(scene), EventKind::kBallBall);
        if (one.expect.at("first_entering").is_null()) {
            EXPECT_TRUE(found.empty());
            continue;
        }
        ASSERT_EQ(1U, found.size());
        // Near a double root the rounding of da / g is seen 1e5 times magnified.
        EXPECT_NEAR(one.expected("first_entering"), found[0].t, 1e-11);
    }
}

TEST(CurvedContact, DrawBallThatTurnsBackBesideAnotherMissesIt) {
    const auto one = testing::reference_case("b_toi_quartic", "turn_back_graze");
    Scene scene = on_endless_cloth({{0, 0}, {one.input("dp", 0), one.input("dp", 1)}},
                                   {-one.input("dv", 0), 0});
    scene.balls[0].state.w.y = -10 * -one.input("dv", 0) / kRadius;
    EXPECT_EQ(0U, count(simulate(scene), EventKind::kBallBall));
}

/// A draw ball whose curve's turning point lies `gap` m before contact.
Scene turning_before_contact(double gap) {
    // From speed v it slides v^2 / (2 a) on, and back; its slip outlasts the turn.
    const double way = 1.0 / (2 * kSliding);
    Scene scene = on_endless_cloth({{0, 0}, {way + kDiameter + gap, 0}}, {1, 0});
    scene.balls[0].state.w.y = -10 / kRadius;
    return scene;
}

TEST(CurvedContact, DrawBallThatTurnsJustBeforeContactMissesAndJustAfterItHits) {
    for (const double gap : {1e-15, 1e-12, 1e-9, 1e-6, 1e-3}) {
        SCOPED_TRACE(gap);
        EXPECT_EQ(0U, count(simulate(turning_before_contact(gap)), EventKind::kBallBall));
        const auto hits = events_of(simulate(turning_before_contact(-gap)), EventKind::kBallBall);
        ASSERT_EQ(1U, hits.size());
        // What is left to run at contact: v^2 = 2 a gap.
        EXPECT_NEAR(std::sqrt(2 * kSliding * gap), hits[0].before[0].v.x,
                    1e-3 * std::sqrt(2 * kSliding * gap) + 1e-8);
    }
}

TEST(CurvedContact, RollingBallThatWouldStopAtContactHitsOrDoesNot) {
    const double speed = 0.3132091952673163;
    const double way = speed * speed / (2 * kRolling);
    for (int ulps = -4; ulps <= 4; ++ulps) {
        SCOPED_TRACE(ulps);
        double x = way + kDiameter;
        for (int i = 0; i < std::abs(ulps); ++i)
            x = std::nextafter(x, ulps < 0 ? -kInfinity : kInfinity);
        const ShotTrace trace = simulate(rolling({{0, 0}, {x, 0}}, {speed, 0}));
        EXPECT_EQ(Outcome::kRest, trace.outcome);
        EXPECT_LE(count(trace, EventKind::kBallBall), 1U);
        EXPECT_NEAR(x, testing::final_place(trace, 1).x, 1e-12);
        EXPECT_NEAR(way, testing::final_place(trace, 0).x, 1e-12);
    }
}

TEST(CurvedContact, BallThatStopsFourUlpShortOfContactDoesNotTouch) {
    const auto one = testing::reference_case("g_rest_at_contact", "s0.5_4ulp_dn");
    Scene scene = rolling({{0, 0}, {one.input("gap") + kDiameter, 0}}, {one.input("v0"), 0});
    const ShotTrace trace = simulate(scene);
    EXPECT_NEAR(one.expected("stop_distance"), testing::final_place(trace, 0).x, 1e-15);
    EXPECT_NEAR(one.input("gap") + kDiameter, testing::final_place(trace, 1).x, 1e-12);
}

/// Two balls that slip in the same direction: their accelerations are equal, so that one moves
/// uniformly as seen from the other, and the quartic has lost its leading terms.
class EqualAccelerations : public ::testing::TestWithParam<Vec2> {};

INSTANTIATE_TEST_SUITE_P(Directions, EqualAccelerations,
                         ::testing::Values(Vec2{1, 0}, Vec2{-1, 0}, Vec2{0, 1}, Vec2{0, -1},
                                           Vec2{0.6, 0.8}, Vec2{-0.28, 0.96}));

TEST_P(EqualAccelerations, BallsMeetAtTheClosedFormTime) {
    const Vec2 way = GetParam();
    for (const double closing : {1e-3, 0.5, 3.0}) {
        const double gap = 0.05 * closing;
        Scene scene = on_endless_cloth({{0, 0}, (kDiameter + gap) * way}, (2 + closing) * way);
        set_xy(scene.balls[1].state.v, 2 * way);
        const auto hits = events_of(simulate(scene), EventKind::kBallBall);
        ASSERT_LE(1U, hits.size());
        const Vec2 c = xy(scene.balls[1].state.r);
        const Vec2 v = xy(scene.balls[0].state.v) - xy(scene.balls[1].state.v);
        const Quad left = testing::sqrt(Quad{c.x} * c.x + Quad{c.y} * c.y) - Quad{kDiameter};
        const Quad speed = testing::sqrt(Quad{v.x} * v.x + Quad{v.y} * v.y);
        // Places round to 1e-17 m here, of which the gap is a small difference.
        EXPECT_NEAR(1, hits[0].t / testing::to_double(left / speed), 1e-14 + 1e-17 / gap);
    }
}

TEST(CurvedContact, BallsThatRunTheSameCurveNeverMeet) {
    Scene scene = on_endless_cloth({{0, 0}, {kDiameter, 0}, {0, kDiameter}}, {});
    for (SceneBall& ball : scene.balls) {
        ball.state.v = {1.1, -0.3, 0};
        ball.state.w = {30, 20, 4};
    }
    const ShotTrace trace = simulate(scene);
    EXPECT_EQ(Outcome::kRest, trace.outcome);
    EXPECT_EQ(0U, count(trace, EventKind::kBallBall));
}

/// Offset of the line of centres at which a rolling ball just touches: the same as without
/// deceleration.
TEST(CurvedContact, GrazeOfARollingBallIsAHitAndAnUlpOrTrillionthMoreIsAMiss) {
    for (const double side : {1.0, -1.0}) {
        const double graze = side * kDiameter;
        const std::map<double, bool> offsets{{graze, true},
                                             {std::nextafter(graze, 0), true},
                                             {std::nextafter(graze, side * kInfinity), false},
                                             {graze * (1 - 1e-12), true},
                                             {graze * (1 + 1e-12), false}};
        for (const auto& [offset, hit] : offsets) {
            for (const double speed : {0.5, 3.0, 30.0}) {
                const Scene scene = rolling({{0, 0}, {1, offset}}, {speed, 0});
                EXPECT_EQ(hit ? 1U : 0U, count(simulate(scene), EventKind::kBallBall))
                    << offset - graze << " at " << speed << " m/s";
            }
        }
    }
}

}  // namespace
}  // namespace poolhall
