// Whole shots against two other programs: one in 113-bit arithmetic, which bounds rounding, and
// pooltool, which bounds mistakes of the model.

#include "tests/shared/quad_shots.hpp"
#include "tests/shared/solvers.hpp"
#include "tests/shared/traces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>

namespace poolhall {
namespace {

using nlohmann::json;
using testing::final_place;
using testing::number;

// --- quad_shots.json -----------------------------------------------------------------------------

constexpr int kFirstRail = 102;    ///< in the file: W, E, S, N
constexpr int kFirstPocket = 110;  ///< in the file: SW, S, SE, NW, N, NE

/// An impact as the file writes it: ball, other ball or rail or pocket, time.
struct Impact {
    int ball;
    int other;
    double t;
};

std::vector<Impact> impacts_of(const ShotTrace& trace) {
    constexpr std::array kRails{Rail::kWest, Rail::kEast, Rail::kSouth, Rail::kNorth};
    std::vector<Impact> impacts;
    for (const ShotEvent& event : trace.events) {
        const int ball = event.balls[0].value;
        if (event.kind == EventKind::kBallBall)
            impacts.push_back({ball, event.balls[1].value, event.t});
        if (event.kind == EventKind::kBallPocket)
            impacts.push_back({ball, kFirstPocket + static_cast<int>(event.pocket), event.t});
        if (event.kind == EventKind::kBallRail) {
            const auto rail = std::find(std::begin(kRails), std::end(kRails), event.rail);
            impacts.push_back(
                {ball, kFirstRail + static_cast<int>(rail - std::begin(kRails)), event.t});
        }
    }
    return impacts;
}

void expect_impacts(const json& expected, const std::vector<Impact>& impacts, double tolerance) {
    ASSERT_EQ(expected.size(), impacts.size());
    for (std::size_t i = 0; i < impacts.size(); ++i) {
        EXPECT_EQ(expected[i][0], impacts[i].ball) << "impact " << i;
        EXPECT_EQ(expected[i][1], impacts[i].other) << "impact " << i;
        EXPECT_NEAR(expected[i][2].get<double>(), impacts[i].t, tolerance) << "impact " << i;
    }
}

void expect_quad_shot(const json& model, const json& shot, double tolerance) {
    SCOPED_TRACE(shot.at("id").get<std::string>());
    const Scene scene = testing::quad_scene(model, shot);
    const ShotTrace trace = simulate(scene);
    ASSERT_EQ(Outcome::kRest, trace.outcome);
    // A place that is so far off is passed later by that over a speed of some mm/s.
    expect_impacts(shot.at("impacts"), impacts_of(trace), 1e3 * tolerance);
    const Vec2 corner{scene.table.length / 2, scene.table.width / 2};
    for (std::size_t i = 0; i < scene.balls.size(); ++i) {
        const json& ball = shot.at("balls")[i];
        EXPECT_EQ(ball.at("pocketed").get<bool>(), trace.balls[i].motion == Motion::kPocketed);
        const Vec2 rest{number(ball.at("rest")[0]), number(ball.at("rest")[1])};
        EXPECT_LE(norm(final_place(trace, i) + corner - rest), tolerance) << "ball " << i;
    }
}

TEST(QuadShot, OfOneOrTwoBallsEndsWhere113BitArithmeticEnds) {
    const json file = testing::reference_file("quad_shots.json");
    for (const json& shot : file.at("shots")) {
        if (shot.at("balls").size() <= 2) expect_quad_shot(file.at("model"), shot, 1e-12);
    }
}

TEST(QuadShot, OfARackEndsAsNearTo113BitArithmeticAsRoundingLets) {
    const json file = testing::reference_file("quad_shots.json");
    for (const json& shot : file.at("shots")) {
        if (shot.at("balls").size() <= 2) continue;
        // A break magnifies rounding from impact to impact; the file has what doubles make of it.
        const double tolerance = std::max(1e-12, 10 * shot.at("double_err").get<double>());
        expect_quad_shot(file.at("model"), shot, tolerance);
    }
}

// --- pooltool_shots.json -------------------------------------------------------------------------

/// pooltool's x runs across the table and its y along it: a quarter turn.
Vec3 turned(const json& a) {
    return {a[1].get<double>(), -a[0].get<double>(), a[2].get<double>()};
}

RailSpec rail_of(const std::string& model, const json& parameters) {
    RailSpec rail{RailModel::kElastic};
    if (model == "unrealistic_restitution") rail.model = RailModel::kRestitution;
    if (model == "han_2005") rail.model = RailModel::kHan2005;
    if (model == "mathavan_2010_fine") rail.model = RailModel::kMathavan2010;
    rail.e = parameters.at("e_rail");
    rail.mu = parameters.at("mu_rail");
    rail.nose_height = parameters.at("nose_height");
    return rail;
}

BallBallSpec ball_ball_of(const json& shot) {
    BallBallSpec spec{BallBallModel::kElastic};
    if (shot.at("ball_ball") == "frictionless_elastic") return spec;
    spec.model = BallBallModel::kFriction;
    spec.e = shot.at("e_ball");
    // pooltool takes the impulse of friction as mu e times the closing speed, where the normal
    // impulse is (1 + e) / 2 times it.
    spec.mu = shot.at("mu_ball").get<double>() * 2 * spec.e / (1 + spec.e);
    return spec;
}

/// Where `r` (pooltool's x and y) is in our frame.
Vec2 place(const Table& table, const json& r) {
    return {r[1].get<double>() - table.length / 2, table.width / 2 - r[0].get<double>()};
}

Scene pooltool_scene(const json& parameters, const json& shot) {
    Scene scene;
    scene.table.length = shot.at("length");
    scene.table.width = shot.at("width");
    scene.ball = {parameters.at("radius"), parameters.at("mass")};
    scene.gravity = parameters.at("gravity");
    scene.effects.sliding = SlidingSpec{parameters.at("sliding")};
    scene.effects.rolling = RollingSpec{parameters.at("rolling")};
    scene.effects.spin_decay = SpinDecaySpec{parameters.at("spin_decay")};
    scene.effects.ball_ball = ball_ball_of(shot);
    scene.effects.rail = rail_of(shot.at("rail"), parameters);
    scene.solver.kind = SolverKind::kEvent;
    for (const json& ball : shot.at("balls")) {
        SceneBall one{std::to_string(scene.balls.size()), {}};
        set_xy(one.state.r, place(scene.table, ball.at("r")));
        one.state.v = turned(ball.at("v"));
        one.state.w = turned(ball.at("w"));
        scene.balls.push_back(one);
    }
    return scene;
}

EventKind kind_of(const std::string& type) {
    if (type == "ball_ball") return EventKind::kBallBall;
    if (type == "ball_linear_cushion") return EventKind::kBallRail;
    if (type == "sliding_rolling") return EventKind::kSlideToRoll;
    if (type == "spinning_stationary") return EventKind::kSpinToRest;
    return EventKind::kRollToRest;
}

/// m; how far that engine's numbers can be trusted.
double tolerance_of(const json& shot) {
    // First-order steps of impulse.
    if (shot.at("rail") == "mathavan_2010_fine") return 1e-5;
    // `sensitivity` is to a spacer of 1e-6 m; the shots are with one of 1e-10 m. Without an impact
    // only rounding at x = 50 m is left.
    return std::max(1e-12, 1e-3 * shot.at("sensitivity").get<double>());
}

void expect_pooltool_shot(const json& parameters, const json& shot) {
    SCOPED_TRACE(shot.at("id").get<std::string>() + ": " + shot.at("what").get<std::string>());
    const Scene scene = pooltool_scene(parameters, shot);
    const ShotTrace trace = simulate(scene);
    const json& expected = shot.at("events");
    ASSERT_EQ(expected.size(), trace.events.size());
    const double tolerance = tolerance_of(shot);
    for (std::size_t i = 0; i < trace.events.size(); ++i) {
        const ShotEvent& event = trace.events[i];
        EXPECT_EQ(name(kind_of(expected[i][1])), name(event.kind)) << "event " << i;
        EXPECT_EQ(expected[i][2][0], event.balls[0].value) << "event " << i;
        EXPECT_NEAR(expected[i][0].get<double>(), event.t, 10 * tolerance) << "event " << i;
    }
    for (std::size_t i = 0; i < scene.balls.size(); ++i) {
        const Vec2 rest = place(scene.table, shot.at("balls")[i].at("rest"));
        EXPECT_LE(norm(final_place(trace, i) - rest), tolerance) << "ball " << i;
    }
}

TEST(PooltoolShot, HasTheSameEventsAndEndsAtTheSamePlaces) {
    const json file = testing::reference_file("pooltool_shots.json");
    for (const json& shot : file.at("shots"))
        expect_pooltool_shot(file.at("parameters"), shot);
}

}  // namespace
}  // namespace poolhall
