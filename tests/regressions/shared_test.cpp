// One test a bug of the simulation that was found and mended.

#include "shared/physics/contact/contact.hpp"
#include "shared/physics/contact/contact_time.hpp"
#include "shared/physics/contact/time_of_impact.hpp"
#include "tests/shared/contacts.hpp"
#include "tests/shared/scenes.hpp"
#include "tests/shared/solvers.hpp"
#include "tests/shared/traces.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace poolhall {
namespace {

constexpr double kDiameter = 2 * BallSpec{}.radius;

TEST(Regression, WayBackFromAnOverlapBelowRoundingIsNotNan) {
    // The offset rounded to more than the diameter, and the root's argument to less than nothing.
    testing::Random random(1);
    for (int i = 0; i < 100000; ++i) {
        const Vec2 v = random.direction();
        const Vec2 along = normalized(v);
        const Vec2 c = std::nextafter(kDiameter, 0) * Vec2{-along.y, along.x};
        ASSERT_FALSE(std::isnan(time_since_impact({{}, {}}, {c, v}, kDiameter))) << i;
    }
}

TEST(Regression, WayBackAtTheSlowestSpeedIsNotNan) {
    Scene scene = testing::scene_of({{0, 0}, {kDiameter - 0.5e-9, 0}});
    scene.balls[0].state.v.x = 1e-200;
    scene.solver.kind = SolverKind::kOverlap;
    scene.limits.time = 0.1;
    const ShotTrace trace = simulate(scene);
    EXPECT_TRUE(std::isfinite(trace.balls[0].state.r.x));
    EXPECT_TRUE(std::isfinite(trace.balls[1].state.r.x));
}

TEST(Regression, BallTooSlowToSquareItsSpeedStopsInNoKernelWithoutFriction) {
    for (const double speed : {1e-200, -5e-324}) {
        Scene scene = testing::scene_of({0, 0}, {speed, 0});
        scene.limits.time = 0.1;
        for (const SolverKind solver : testing::kAllSolvers) {
            scene.solver.kind = solver;
            for (const std::string_view kernel : kernel_names()) {
                ShotTrace trace;
                if (!simulate_by(kernel, scene, 0, trace)) continue;
                EXPECT_EQ(Outcome::kTimeLimit, trace.outcome) << kernel << " by " << name(solver);
            }
        }
    }
}

TEST(Regression, BallThatRollsHasTheSpinOfItsSpeedWhenItIsCutOffOrCaptured) {
    Scene scene = testing::scene_of({0, 0.6}, {2, 0});
    scene.effects = testing::cloth_effects();
    scene.limits.time = 2;
    Scene at_pocket = scene;
    at_pocket.table.pockets = PocketModel::kCircles;
    at_pocket.table.circles = {{"NE", {1.27, 0.635}, 0.1}};
    for (const SolverKind solver : testing::kAllSolvers) {
        scene.solver.kind = at_pocket.solver.kind = solver;
        const BallState cut_off = simulate(scene).balls[0].state;
        const auto captures = testing::events_of(simulate(at_pocket), EventKind::kBallPocket);
        ASSERT_EQ(1U, captures.size()) << name(solver);
        for (const BallState& state : {cut_off, captures[0].before[0]})
            EXPECT_NEAR(state.v.x, state.w.y * BallSpec{}.radius, 1e-12) << name(solver);
    }
}

TEST(Regression, BallsThatOnlyRollingResistanceTurnsTowardsEachOtherMeetByEveryKernel) {
    // The kernel `roll` went on to think that they had parted. A heavy ball holds a row up.
    testing::Random random(8);
    for (int i = 0; i < 50; ++i) {
        const Vec2 aside = kDiameter * normalized(Vec2{-random.uniform(0.2, 0.6), -1});
        Scene scene = testing::scene_of({aside, {0, 0}, {kDiameter, 0}, {2 * kDiameter, 0}});
        scene.effects.rolling = RollingSpec{random.uniform(0.003, 0.03)};
        scene.effects.ball_ball.model = BallBallModel::kFriction;
        scene.effects.ball_ball.e = random.uniform(0, 0.3);
        scene.balls[3].mass = 2;
        scene.balls[0].state.v = {0, random.uniform(0.03, 0.1), 0};
        ASSERT_FALSE(check(scene));
        ShotTrace all;
        ASSERT_TRUE(simulate_by("everything", scene, 0, all));
        EXPECT_EQ(all.hash, simulate(scene).hash) << i;
    }
}

TEST(Regression, EventsAtTheEndOfATickDoNotLieBehindThoseOfTheNext) {
    // Balls that reach a rail at the very end of a tick, and others that leave one with the next.
    testing::Random random(2);
    const Vec2 edge = inset(Table{}, BallSpec{}.radius);
    for (int tick = 1; tick < 300; ++tick) {
        const double end = tick / 30.0;
        std::vector<Vec2> places(6);
        for (int i = 0; i < 6; ++i)
            places[static_cast<std::size_t>(i)].y = -0.5 + 0.2 * i;
        Scene scene = testing::scene_of(places);
        for (SceneBall& ball : scene.balls)
            ball.state.v.x = edge.x / (end * (1 + random.uniform(-2, 2) * 0x1p-52));
        scene.limits.time = end + 0.1;
        double last = 0;
        for (const ShotEvent& event : simulate(scene).events) {
            ASSERT_LE(last, event.t) << "tick " << tick;
            last = event.t;
        }
    }
}

TEST(Regression, VelocitiesOfAGroupDoNotDependOnTheOrderOfItsContacts) {
    testing::Random random(3);
    const double half_root_three = std::sqrt(3.0) / 2;
    for (int i = 0; i < 1000; ++i) {
        std::vector<MovingBall> balls(3);
        for (MovingBall& ball : balls) {
            ball.radius = BallSpec{}.radius;
            ball.mass = BallSpec{}.mass;
        }
        balls[0].v = {1, random.uniform(-0.2, 0.2)};
        balls[1].r = kDiameter * Vec2{half_root_three, 0.5};
        balls[2].r = kDiameter * Vec2{half_root_three, -0.5};
        std::vector<MovingBall> turned = balls;
        const Contact north = ball_contact(0, 1);
        const Contact south = ball_contact(0, 2);
        ASSERT_TRUE(testing::resolve_contacts({north, south}, 1, balls));
        ASSERT_TRUE(testing::resolve_contacts({south, north}, 1, turned));
        for (std::size_t ball = 0; ball < 3; ++ball)
            ASSERT_EQ(balls[ball].v, turned[ball].v) << i;
    }
}

TEST(Regression, BallsAgainstDeadRailsHandNoRoundingToAndFro) {
    // Found by random clusters: a ball in a corner whose rails take everything, touched by one that
    // rolls by. An impact's 1e-18 m/s went into the rails, and the next impact came at once.
    Scene scene = testing::scene_of({{0x1.4acb21a15b954p-2, -0x1.1e7b4f1ca48adp-1},
                                     {0x1.4acb21a15b954p-2, -0x1.01388b52b5bedp-1},
                                     {0x1.4acb21a15b954p-2, -0x1.c7eb8f118de5bp-2},
                                     {-0x1.69fc19c4cde9p-1, -0x1.367d566cf41f2p-1},
                                     {-0x1.789d7ba9c54fp-1, -0x1.1d26251e06e9dp-1}});
    set_xy(scene.balls[0].state.v, {0x1.d7e2bdc10838ep-2, -0x1.2566bc7249f28p-5});
    set_xy(scene.balls[4].state.v, {0x1.647ec5a530944p+2, -0x1.ab27d669ef24cp+2});
    scene.effects.linear_drag = LinearDragSpec{};
    scene.effects.rail = {RailModel::kRestitution, 0};
    const ShotTrace trace = simulate(scene);
    EXPECT_EQ(Outcome::kRest, trace.outcome);
    EXPECT_LT(trace.events.size(), 50U);
}

/// A ball in the mouth of the north-eastern pocket, between jaws of 21 mm, by the event solver.
Scene in_the_mouth(const BallState& state) {
    Scene scene = testing::scene_of({xy(state.r)});
    scene.balls[0].state = state;
    scene.table.pockets = PocketModel::kPool;
    scene.table.mouths.emplace().corner.jaw_radius = 0.02095;
    scene.effects = lab::cloth_effects();
    scene.solver.kind = SolverKind::kEvent;
    return scene;
}

TEST(Regression, BallThatItsSpinBringsBackToAJawTouchesItAgain) {
    // It had left the jaw that it touched, so the search had done with that jaw.
    const ShotTrace trace = simulate(
        in_the_mouth({{0x1.301eb7bb214cbp+0, 0x1.36c0e8a5de3aep-1, 0},
                      {0x1.b78bdb8712fe3p-4, -0x1.9d9f70428c8p-12, 0},
                      {-0x1.567a796f09637p+5, 0x1.5bb0967b1493dp+5, 0x1.23118d4a4eea6p+4}}));
    ASSERT_FALSE(trace.events.empty());
    EXPECT_EQ(EventKind::kBallRail, trace.events[0].kind);
    EXPECT_NEAR(0.0365, trace.events[0].t, 1e-4);
}

TEST(Regression, BallThatCurvesRoundAJawTouchesTheFacingBehindIt) {
    // From beside the jaw it was behind the facing's line, and the search had left the line out.
    const ShotTrace trace = simulate(
        in_the_mouth({{0x1.337f54ba19832p+0, 0x1.38b8e6541886cp-1, 0},
                      {0x1.903268524a90cp-3, 0x1.ea41c90ca2de8p-5, 0},
                      {-0x1.415ef6e48026dp+7, 0x1.0d1c4e88f9959p+6, -0x1.439075ad5c04ep+2}}));
    ASSERT_FALSE(trace.events.empty());
    EXPECT_EQ(EventKind::kBallRail, trace.events[0].kind);
}

TEST(Regression, BallsThatTouchToWithinRoundingAndArePressedMeetAtOnce) {
    // After an impact with e = 0: a gap of 2e-19 m^2 that closes. Newton's method had not come to
    // the root within the steps that it was given, and the balls overlapped by 4 um.
    const RelativeArc<Vec2> arc{{-0x1.7ee32ed95941p-5, -0x1.0d698c0fb432p-5},
                                {-0x1.4dbd060feeab4p-3, 0x1.da4eae1e61d26p-3},
                                {0x1.b684756dab2eep+1, 0x1.d6e54852a2e2ep+0}};
    for (const double horizon : {1e-3, 0.01, 0.02, 0.05, 0.3})
        EXPECT_LE(first_contact(arc, kDiameter, horizon), 1e-8) << horizon;
}

TEST(Regression, BallThatJumpsComesToRestByStepsToo) {
    // Explicit Euler let it come down faster than it had left, and it bounced up to the time limit.
    for (const SolverKind kind : {SolverKind::kEuler, SolverKind::kSemiImplicit}) {
        for (const double e : {0.5, 0.9, 0.98}) {
            for (const double hz : {15, 30, 240}) {
                Scene scene = testing::scene_of({{-1, 0}});
                scene.effects = lab::cloth_effects();
                scene.effects.airborne = AirborneSpec{e};
                scene.balls[0].state.v = {1, 0.2, 2};
                scene.solver = {kind, hz};
                const ShotTrace trace = simulate(scene);
                EXPECT_EQ(Outcome::kRest, trace.outcome) << name(kind) << ' ' << hz << ' ' << e;
                EXPECT_LT(trace.events.size(), 300U);
            }
        }
    }
}

}  // namespace
}  // namespace poolhall
