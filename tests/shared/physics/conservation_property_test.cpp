#include "tests/shared/scenes.hpp"
#include "tests/shared/traces.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace poolhall {
namespace {

constexpr double kDiameter = 2 * BallSpec{}.radius;
constexpr double kUlp = std::numeric_limits<double>::epsilon();

/// A random scene with or without drag, loss at the rails, and pockets.
Scene scene_number(int i, testing::Random& random) {
    Scene scene = testing::random_scene(random, 2 + random.below(15), random.uniform(0.1, 30));
    if (i % 2 == 0) scene.effects.linear_drag.reset();
    if (i % 3 == 0) scene.effects.rail = {RailModel::kRestitution, random.uniform(0, 1)};
    if (i % 5 == 0) scene.table.pockets = PocketModel::kEndGame;
    scene.limits.time = 10;
    return scene;
}

double energy(const ShotEvent& event, const std::array<BallState, 2>& states) {
    double sum = 0;
    for (std::size_t i = 0; i < event.ball_count; ++i)
        sum += dot(xy(states[i].v), xy(states[i].v));
    return sum;
}

class EveryImpact : public ::testing::TestWithParam<SolverKind> {
  protected:
    /// Calls `look` with every event of 400 random shots.
    template <class Look>
    void for_each_event(Look look) {
        testing::Random random(31);
        for (int i = 0; i < 400; ++i) {
            Scene scene = scene_number(i, random);
            scene.solver.kind = GetParam();
            SCOPED_TRACE(i);
            const ShotTrace trace = simulate(scene);
            for (const ShotEvent& event : trace.events)
                look(event);
        }
    }
};

INSTANTIATE_TEST_SUITE_P(Solvers, EveryImpact,
                         ::testing::Values(SolverKind::kEuler, SolverKind::kOverlap),
                         [](const auto& test) { return std::string(name(test.param)); });

TEST_P(EveryImpact, OfTwoBallsKeepsMomentumToFourUlp) {
    int impacts = 0;
    for_each_event([&](const ShotEvent& event) {
        if (event.kind != EventKind::kBallBall) return;
        ++impacts;
        const auto& [a, b] = event.before;
        const auto& [after_a, after_b] = event.after;
        const double scale = std::max(norm(xy(a.v)), norm(xy(b.v)));
        EXPECT_NEAR(a.v.x + b.v.x, after_a.v.x + after_b.v.x, 4 * kUlp * scale);
        EXPECT_NEAR(a.v.y + b.v.y, after_a.v.y + after_b.v.y, 4 * kUlp * scale);
    });
    EXPECT_GT(impacts, 1000);
}

TEST_P(EveryImpact, KeepsEnergyOrLosesIt) {
    for_each_event([&](const ShotEvent& event) {
        if (event.kind == EventKind::kStrike) return;
        const double before = energy(event, event.before);
        EXPECT_LE(energy(event, event.after), before * (1 + 16 * kUlp)) << name(event.kind);
        if (event.kind == EventKind::kBallBall) {
            EXPECT_GE(energy(event, event.after), before * (1 - 16 * kUlp));
        }
    });
}

TEST_P(EveryImpact, LeavesTheBallsWhereTheyAre) {
    for_each_event([&](const ShotEvent& event) {
        for (std::size_t i = 0; i < event.ball_count; ++i)
            EXPECT_EQ(event.before[i].r, event.after[i].r);
        // The overlap solver goes back to one impact a pair; what else happened in the tick is
        // lost.
        if (event.kind != EventKind::kBallBall || GetParam() == SolverKind::kOverlap) return;
        EXPECT_NEAR(kDiameter, norm(xy(event.after[0].r) - xy(event.after[1].r)), 1e-12);
    });
}

TEST_P(EveryImpact, ComesInOrderOfTime) {
    double last = 0;
    for_each_event([&](const ShotEvent& event) {
        if (event.kind == EventKind::kStrike) last = 0;
        EXPECT_LE(last, event.t);
        last = event.t;
    });
}

/// When each ball is captured, s.
std::vector<double> captures_in(const ShotTrace& trace) {
    std::vector<double> gone(trace.balls.size(), std::numeric_limits<double>::infinity());
    for (const ShotEvent& event : testing::events_of(trace, EventKind::kBallPocket))
        gone[event.balls[0].value] = event.t;
    return gone;
}

void expect_balls_apart(const ShotTrace& trace, std::size_t sample,
                        const std::vector<double>& gone) {
    const double t = static_cast<double>(sample) / 30;
    for (std::size_t a = 0; a < gone.size(); ++a) {
        for (std::size_t b = 0; b < a && t < gone[a]; ++b) {
            if (t >= gone[b]) continue;
            const Vec2 c = xy(trace.sample(sample, a)) - xy(trace.sample(sample, b));
            EXPECT_GE(norm(c), kDiameter - 1e-9);
        }
    }
}

TEST(EveryTick, AllBallsAreOnTheTableAndApart) {
    testing::Random random(32);
    for (int i = 0; i < 200; ++i) {
        const Scene scene = scene_number(i, random);
        const Vec2 edge = inset(scene.table, scene.ball.radius);
        const ShotTrace trace = simulate(scene, 30);
        ASSERT_NE(Outcome::kStalled, trace.outcome);
        const std::vector<double> gone = captures_in(trace);
        for (std::size_t k = 0; k < trace.sample_count(); ++k) {
            for (std::size_t a = 0; a < scene.balls.size(); ++a) {
                EXPECT_LE(std::abs(trace.sample(k, a).x), edge.x + 1e-12);
                EXPECT_LE(std::abs(trace.sample(k, a).y), edge.y + 1e-12);
            }
            expect_balls_apart(trace, k, gone);
        }
    }
}

TEST(EveryTick, ShotsUnderDragEndWithinTheirBound) {
    testing::Random random(33);
    for (int i = 0; i < 200; ++i) {
        const double speed = random.uniform(0.1, 30);
        const Scene scene = testing::random_scene(random, 2 + random.below(15), speed);
        const ShotTrace trace = simulate(scene);
        ASSERT_EQ(Outcome::kRest, trace.outcome);
        // No impact can make a ball faster than all the energy of the strike.
        EXPECT_LE(trace.duration, std::log(speed / 0.0625) / 0.6 + 2.0 / 30);
    }
}

/// Balls each of which touches one before it, at random or on a rail, some of them moving.
Scene cluster(testing::Random& random) {
    const Vec2 edge = inset(Table{}, BallSpec{}.radius);
    const std::size_t count = 3 + random.below(13);
    std::vector<Vec2> places{{random.uniform(-edge.x, edge.x), random.uniform(-edge.y, edge.y)}};
    while (places.size() < count) {
        const Vec2 beside =
            places[random.below(places.size())] + kDiameter * normalized(random.direction());
        const Vec2 at_rail{random.uniform(-edge.x, edge.x), edge.y};
        const Vec2 place = random.below(5) == 0 ? at_rail : beside;
        bool free = std::abs(place.x) <= edge.x && std::abs(place.y) <= edge.y;
        for (const Vec2 other : places)
            free = free && norm(place - other) >= kDiameter - 1e-10;
        if (free) places.push_back(place);
    }
    Scene scene = testing::scene_of(places);
    scene.effects.linear_drag = LinearDragSpec{};
    for (std::size_t i = 0; i < 1 + random.below(3); ++i)
        set_xy(scene.balls[random.below(count)].state.v,
               random.uniform(0.1, 15) * random.direction());
    return scene;
}

TEST(EveryTick, ClustersOfTouchingBallsComeToRestInFewEvents) {
    testing::Random random(34);
    for (int i = 0; i < 3000; ++i) {
        Scene scene = cluster(random);
        if (i % 3 != 0) scene.effects.rail = {RailModel::kRestitution, i % 3 == 1 ? 0 : 0.8};
        ASSERT_FALSE(check(scene));
        const ShotTrace trace = simulate(scene);
        ASSERT_EQ(Outcome::kRest, trace.outcome) << i;
        ASSERT_LT(trace.events.size(), 500U) << i;
    }
}

}  // namespace
}  // namespace poolhall
