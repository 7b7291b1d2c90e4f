// Which of the effects that a scene names can act is proven before the shot; whatever is left out,
// the shot is the same to the last bit.

#include "client/lab/corpora/real_play.hpp"
#include "shared/analysis/effect_use.hpp"
#include "shared/physics/simulate.hpp"
#include "tests/shared/random.hpp"
#include "tests/shared/scenes.hpp"
#include "tests/shared/solvers.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace poolhall {
namespace {

constexpr double kRadius = BallSpec{}.radius;

/// A table with mouths and all effects, by `event`; ball 0 is struck along x.
Scene full_table(const std::vector<Vec2>& places, double speed) {
    Scene scene = testing::scene_of(places);
    scene.table.pockets = PocketModel::kPool;
    scene.effects = testing::pool_effects();
    scene.effects.airborne = AirborneSpec{};
    scene.solver.kind = SolverKind::kEvent;
    scene.strike = Strike{BallIndex{0}, {1, 0}, speed};
    return scene;
}

/// A ball that rolls along x, and others at rest.
Scene rolling_at(double speed, const std::vector<Vec2>& places) {
    Scene scene = full_table(places, 0);
    scene.strike.reset();
    scene.balls[0].state.v = {speed, 0, 0};
    scene.balls[0].state.w = {0, speed / kRadius, 0};
    return scene;
}

/// How far it rolls, m.
double roll_of(double speed) {
    return speed * speed / (2 * 0.01 * 9.81);
}

/// The bound by which the shot rules the effect out; nothing if it may act.
std::optional<Bound> bound_of(const Scene& scene, std::string_view effect) {
    for (const analysis::EffectUse& use : analysis::effect_uses(scene, simulate(scene))) {
        if (use.effect == effect) return use.ruled_out;
    }
    ADD_FAILURE() << effect << " is not named";
    return std::nullopt;
}

/// By every solver that takes the scene, with and without proof.
void expect_same_as_by_everything(Scene scene) {
    for (const SolverKind solver : testing::kAllSolvers) {
        scene.solver = {solver, 60};
        if (check(scene)) continue;
        SCOPED_TRACE(name(solver));
        const ShotTrace proven = simulate(scene, 30);
        ShotTrace whole;
        ASSERT_TRUE(simulate_by("everything", scene, 30, whole));
        EXPECT_EQ(whole.hash, proven.hash) << proven.kernel;
        EXPECT_EQ(whole.events, proven.events);
        EXPECT_EQ(whole.balls, proven.balls);
        EXPECT_EQ(whole.samples, proven.samples);
        EXPECT_EQ(whole.duration, proven.duration);
    }
}

TEST(CalledFor, FlightIsRuledOutByALevelCueAndByNoOther) {
    Scene scene = full_table({{0, 0}, {0.5, 0.01}}, 2);
    EXPECT_EQ(Bound::kLevelCue, bound_of(scene, "airborne"));
    for (const double elevation : {1e-9, 1e-300, 0.1}) {
        scene.strike->elevation = elevation;
        EXPECT_FALSE(bound_of(scene, "airborne")) << elevation;
        expect_same_as_by_everything(scene);
    }
}

TEST(CalledFor, ABallInTheAirOrOfAnotherSizeMayFly) {
    Scene high = full_table({{0, 0}, {0.5, 0.01}}, 2);
    high.balls[1].state.r.z = 0.1;
    EXPECT_FALSE(bound_of(high, "airborne"));
    Scene larger = full_table({{0, 0}, {0.5, 0.01}}, 2);
    larger.balls[0].radius = 0.03;
    EXPECT_FALSE(bound_of(larger, "airborne"));
    expect_same_as_by_everything(larger);
    // But not where they do not meet.
    larger.strike->speed = 0.1;
    EXPECT_EQ(Bound::kLevelCue, bound_of(larger, "airborne"));
    expect_same_as_by_everything(larger);
}

TEST(CalledFor, SpinAboutTheVerticalIsRuledOutWhereNothingMakesIt) {
    Scene scene = full_table({{0, 0}, {0.5, 0.01}}, 2);
    EXPECT_FALSE(bound_of(scene, "spin_decay"));
    scene.effects.ball_ball.model = BallBallModel::kRestitution;
    EXPECT_FALSE(bound_of(scene, "spin_decay"));
    scene.effects.rail.model = RailModel::kRestitution;
    EXPECT_EQ(Bound::kNoSideSpin, bound_of(scene, "spin_decay"));
    expect_same_as_by_everything(scene);
    scene.strike->offset = {1e-9, 0.3};
    EXPECT_FALSE(bound_of(scene, "spin_decay"));
}

TEST(CalledFor, RailsMouthsAndThrowAreRuledOutWhereNobodyGetsThere) {
    const Scene tap = full_table({{0, 0}, {0.5, 0}, {-0.5, 0.3}}, 0.3);
    EXPECT_EQ(Bound::kOutOfReach, bound_of(tap, "pool_mouths"));
    EXPECT_EQ(Bound::kNoMeeting, bound_of(tap, "throw"));
    EXPECT_EQ(Bound::kNoSideSpin, bound_of(tap, "spin_decay"));
    const ShotTrace trace = simulate(tap);
    EXPECT_EQ("slide_roll", trace.kernel);
    EXPECT_EQ(
        "called for: sliding, rolling. Ruled out: spin (nothing makes any), jump (level cue), "
        "rails and pockets (no ball reaches one), throw (no two balls meet)",
        analysis::in_words(analysis::effect_uses(tap, trace)));
    expect_same_as_by_everything(tap);
}

TEST(CalledFor, ABallAloneIsNotThrown) {
    for (const double speed : {0.5, 8.0}) {
        Scene scene = full_table({{0, 0.1}}, speed);
        EXPECT_EQ(Bound::kNoMeeting, bound_of(scene, "throw"));
        scene.strike->offset = {0.3, 0};
        expect_same_as_by_everything(scene);
    }
}

TEST(CalledFor, NothingIsWhereNothingMoves) {
    const Scene scene = full_table({{0, 0}, {0.5, 0}}, 0);
    EXPECT_EQ(Bound::kNothingMoves, bound_of(scene, "sliding"));
    EXPECT_EQ("open_cloth", simulate(scene).kernel);
    expect_same_as_by_everything(scene);
}

TEST(CalledFor, ABallThatJustReachesMeetsAndOneThatJustDoesNotIsLeftAlone) {
    constexpr double kSpeed = 0.3;
    for (const double gap : {-1e-6, -1e-10, 0.0, 1e-10, 1e-9, 1e-7, 1e-6}) {
        SCOPED_TRACE(gap);
        const double way = roll_of(kSpeed) + gap;
        expect_same_as_by_everything(rolling_at(kSpeed, {{0, 0}, {way + 2 * kRadius, 0}}));
        expect_same_as_by_everything(rolling_at(kSpeed, {{1.27 - kRadius - way, 0}}));
        Scene circle = rolling_at(kSpeed, {{0, 0}});
        circle.table.pockets = PocketModel::kCircles;
        circle.table.circles = {{"there", {way + 0.06, 0}, 0.06}};
        expect_same_as_by_everything(circle);
    }
    const Scene far = rolling_at(kSpeed, {{0, 0}, {roll_of(kSpeed) + 2 * kRadius + 1e-4, 0}});
    EXPECT_EQ(Bound::kNoMeeting, bound_of(far, "throw"));
    const Scene near = rolling_at(kSpeed, {{0, 0}, {roll_of(kSpeed) + 2 * kRadius - 1e-4, 0}});
    EXPECT_FALSE(bound_of(near, "throw"));
}

TEST(CalledFor, AFrozenRowHandsATapOnToItsLastBall) {
    std::vector<Vec2> row{{-0.3, 0}};
    for (int i = 1; i < 10; ++i)
        row.push_back({-0.3 + 2 * kRadius * i, 0});
    row.push_back({-0.3, 0.4});
    for (const double speed : {1e-9, 1e-3, 0.02, 0.1, 0.3}) {
        SCOPED_TRACE(speed);
        expect_same_as_by_everything(full_table(row, speed));
    }
}

TEST(CalledFor, AHeavyBallMayDriveALightOneTwiceAsFast) {
    for (const double light : {0.001, 0.05, 0.16}) {
        Scene scene = full_table({{0, 0}, {0.1, 0.005}, {0.3, 0.02}, {-0.4, 0.3}}, 0.12);
        scene.balls[1].mass = light;
        SCOPED_TRACE(light);
        expect_same_as_by_everything(scene);
    }
}

TEST(CalledFor, SpinAloneDrivesABall) {
    for (const Vec3 spin : {Vec3{0, 60, 0}, Vec3{-200, 0, 0}, Vec3{0, 0, 50}, Vec3{3, 20, -40}}) {
        Scene scene = rolling_at(0, {{0.2, 0.3}, {0.35, 0.3}, {-1, -0.4}});
        scene.balls[0].state.w = spin;
        expect_same_as_by_everything(scene);
    }
}

TEST(CalledFor, OtherTablesGiveTheSameShots) {
    for (const PocketModel pockets : {PocketModel::kNone, PocketModel::kEndGame}) {
        for (const double speed : {0.05, 0.3, 1.0}) {
            Scene scene = full_table({{0.9, 0.5}, {0.97, 0.5}, {-0.5, 0}}, speed);
            scene.table.pockets = pockets;
            scene.effects.rail.e = 1;
            expect_same_as_by_everything(scene);
            scene.effects = {};
            scene.effects.linear_drag = LinearDragSpec{};
            expect_same_as_by_everything(scene);
            scene.table = {.rails = false};
            expect_same_as_by_everything(scene);
        }
    }
}

TEST(CalledFor, AShotThatGetsFartherThanEnergyAllowsIsSimulatedWithAll) {
    // Pressed balls that part at 1 m/s at least have energy from nowhere.
    Scene scene = rolling_at(0.05, {{0, 0}, {2 * kRadius, 0}, {0.5, 0.02}});
    scene.balls[0].state.w.y *= 20;
    scene.effects.ball_ball.min_separation = 1;
    expect_same_as_by_everything(scene);
}

TEST(CalledFor, BallsThatNobodyReachesStayInTheTrace) {
    const Scene tap = full_table({{-0.6, 0.2}, {0, 0}, {0.5, 0.3}}, 0.2);
    const ShotTrace trace = simulate(tap, 30);
    ASSERT_EQ(3U, trace.balls.size());
    EXPECT_EQ(tap.balls[2].state, trace.balls[2].state);
    EXPECT_EQ(tap.balls[2].state.r, trace.sample(trace.sample_count() - 1, 2));
}

TEST(CalledFor, ShotsOfRealPlayAreTheSameByAllThatTheyName) {
    constexpr int kShots = 250;
    Simulator simulator;
    Simulator other;
    ShotTrace proven;
    ShotTrace whole;
    for (const lab::PlayKind& kind : lab::kinds_of_play()) {
        testing::Random random(12);
        for (int shot = 0; shot < kShots; ++shot) {
            const Scene scene = kind.make(random);
            if (check(scene)) continue;
            simulator.simulate(scene, 0, proven);
            ASSERT_TRUE(other.simulate_by("everything", scene, 0, whole));
            ASSERT_EQ(whole.hash, proven.hash) << kind.name << ' ' << shot;
            ASSERT_EQ(whole.events, proven.events) << kind.name << ' ' << shot;
        }
    }
}

TEST(CalledFor, WhatIsRuledOutNeverActs) {
    for (const lab::PlayKind& kind : lab::kinds_of_play()) {
        testing::Random random(13);
        for (int shot = 0; shot < 100; ++shot) {
            const Scene scene = kind.make(random);
            if (check(scene)) continue;
            ShotTrace whole;
            ASSERT_TRUE(simulate_by("everything", scene, 0, whole));
            whole.effects = simulate(scene).effects;
            const auto proven = analysis::effect_uses(scene, whole);
            whole.effects = EffectAccount(scene, Prospect{});
            const auto seen = analysis::effect_uses(scene, whole);
            ASSERT_EQ(seen.size(), proven.size());
            for (std::size_t i = 0; i < seen.size(); ++i)
                EXPECT_FALSE(proven[i].ruled_out && seen[i].acted)
                    << kind.name << ' ' << shot << ' ' << seen[i].effect;
        }
    }
}

}  // namespace
}  // namespace poolhall
