// What the event solver passes over is what never meets, and few balls and many are searched alike.

#include "shared/physics/contact/contact_time.hpp"
#include "shared/physics/search/boxes.hpp"
#include "shared/physics/search/soonest.hpp"
#include "shared/physics/simulate.hpp"
#include "tests/shared/random.hpp"
#include "tests/shared/scenes.hpp"
#include "tests/shared/solvers.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace poolhall {
namespace {

using testing::Random;

constexpr std::size_t kNoneIsMany = std::numeric_limits<std::size_t>::max();
constexpr double kDistance = 2 * BallSpec{}.radius;

/// Where two balls of a table are as seen from each other, and how they slide or roll.
RelativeArc<Vec2> random_arc(Random& random) {
    return {random.uniform(1, 12) * kDistance * normalized(random.direction()),
            random.uniform(0, 4) * random.direction(),
            random.uniform(0.05, 4) * random.direction()};
}

TEST(StayApart, NeverHoldsForTwoThatMeet) {
    Random random(11);
    int apart = 0;
    int never = 0;
    for (int i = 0; i < 200000; ++i) {
        const RelativeArc<Vec2> arc = random_arc(random);
        const double horizon = random.uniform(0, 2);
        const bool meet = first_contact(arc, kDistance, horizon) < kNever;
        never += meet ? 0 : 1;
        if (!stay_apart(arc.c, arc.v, arc.a, kDistance, horizon)) continue;
        ++apart;
        ASSERT_FALSE(meet) << i;
        for (int step = 0; step <= 64; ++step) {
            const double t = step * (horizon / 64);
            const Vec2 c = arc.c + t * (arc.v + (t / 2) * arc.a);
            ASSERT_GE(norm(c), kDistance) << i << " at " << t;
        }
    }
    EXPECT_GT(apart, 0.8 * never);
    EXPECT_LT(never, 190000);
}

TEST(StayApart, HoldsForBallsThatPartAfterTheirImpact) {
    // Sliding apart with accelerations that bring them together only later.
    EXPECT_TRUE(stay_apart({kDistance, 0}, {1, 0.3}, {-2, 0}, kDistance, 0.2));
    EXPECT_FALSE(stay_apart({kDistance, 0}, {1, 0}, {-2, 0}, kDistance, 1.1));
}

Box random_box(Random& random) {
    const double x = random.uniform(-1.5, 1.5);
    const double y = random.uniform(-0.8, 0.8);
    const double way = std::abs(random.uniform(-1, 1)) < 0.1 ? 2 : 0.2;
    return {x, x + random.uniform(0, way), y, y + random.uniform(0, way)};
}

bool overlap(const Box& a, const Box& b) {
    return a.low_x <= b.high_x && b.low_x <= a.high_x && a.low_y <= b.high_y && b.low_y <= a.high_y;
}

class BoxesOf : public ::testing::TestWithParam<std::size_t> {
  protected:
    static constexpr Box kRoom{-1.6, 3.6, -0.9, 2.9};

    void SetUp() override {
        few.reset(GetParam(), kRoom, kNoneIsMany);
        many.reset(GetParam(), kRoom, 1);
        boxes.resize(GetParam());
        for (std::size_t i = 0; i < GetParam(); ++i)
            move(i);
    }

    void move(std::size_t ball) {
        boxes[ball] = random_box(random);
        few.set(ball, boxes[ball]);
        many.set(ball, boxes[ball]);
    }

    static std::vector<std::size_t> found(const Boxes& boxes, std::size_t ball, std::size_t from) {
        std::vector<std::size_t> others;
        boxes.for_each_overlap(ball, from, [&](std::size_t other) { others.push_back(other); });
        return others;
    }

    Random random{5};
    Boxes few;
    Boxes many;
    std::vector<Box> boxes;
};

INSTANTIATE_TEST_SUITE_P(Balls, BoxesOf, ::testing::Values(1, 2, 23, 64, 65, 200));

TEST_P(BoxesOf, EveryOverlapIsFoundInOrderAndLittleElse) {
    std::size_t too_many = 0;
    std::size_t right = 0;
    for (std::size_t step = 0; step < 2000; ++step) {
        const std::size_t ball = step % GetParam();
        move(ball);
        const std::size_t from = step % 3 == 0 ? ball + 1 : 0;
        const auto others = found(few, ball, from);
        ASSERT_EQ(others, found(many, ball, from));
        ASSERT_TRUE(std::is_sorted(others.begin(), others.end()));
        for (std::size_t i = from; i < GetParam(); ++i) {
            const bool is_found = std::binary_search(others.begin(), others.end(), i);
            const bool wanted = i != ball && overlap(boxes[ball], boxes[i]);
            ASSERT_TRUE(is_found || !wanted) << ball << " and " << i;
            (wanted ? right : too_many) += is_found ? 1 : 0;
        }
    }
    EXPECT_LE(100 * too_many, right + 200);  // boxes a step apart
}

TEST_P(BoxesOf, ABallTakenAwayIsFoundNoMoreAndFindsNobody) {
    for (std::size_t ball = 0; ball < GetParam(); ball += 2) {
        few.remove(ball);
        many.remove(ball);
    }
    for (std::size_t ball = 0; ball < GetParam(); ++ball) {
        const auto others = found(few, ball, 0);
        EXPECT_EQ(others, found(many, ball, 0));
        EXPECT_TRUE(std::all_of(others.begin(), others.end(),
                                [](std::size_t other) { return other % 2 == 1; }));
        EXPECT_TRUE(ball % 2 == 1 || others.empty());
    }
    few.set(0, Box::everything());
    many.set(0, Box::everything());
    EXPECT_EQ(GetParam() / 2, found(few, 0, 0).size());
    EXPECT_EQ(GetParam() / 2, found(many, 0, 0).size());
}

TEST(Soonest, FewAndManyBallsHaveTheSameFirstAndTies) {
    for (const std::size_t balls : {1U, 2U, 7U, 32U, 33U, 300U}) {
        Random random(balls);
        Soonest few;
        Soonest many;
        few.reset(balls, kNoneIsMany);
        many.reset(balls, 1);
        std::vector<double> times(balls, kNever);
        for (std::size_t step = 0; step < 3000; ++step) {
            const auto ball =
                static_cast<std::size_t>(random.uniform(0, 1) * static_cast<double>(balls));
            // Whole numbers, for ties.
            const double t = std::floor(random.uniform(0, 40));
            times[ball] = t > 35 ? kNever : t;
            few.set(ball, times[ball]);
            many.set(ball, times[ball]);
            const auto soonest = std::min_element(times.begin(), times.end());
            for (const Soonest::Found& found : {few.find(), many.find()}) {
                ASSERT_EQ(*soonest, found.t);
                if (found.t == kNever) continue;
                ASSERT_EQ(static_cast<std::size_t>(soonest - times.begin()), found.ball);
                ASSERT_EQ(std::count(times.begin(), times.end(), *soonest),
                          static_cast<std::ptrdiff_t>(found.count));
            }
        }
    }
}

TEST(ManyBalls, AreSearchedToTheSameShotsAsFew) {
    Random random(17);
    Simulator few(kNoneIsMany);
    Simulator many(1);
    ShotTrace trace;
    ShotTrace other;
    for (int shot = 0; shot < 120; ++shot) {
        Scene scene = shot % 2 == 0
                          ? testing::break_scene(2 + shot % 5, shot % 3 == 0 ? 0 : 1e-4, 6)
                          : testing::random_scene(random, 40, 5);
        scene.solver.kind = SolverKind::kEvent;
        if (shot % 4 < 2) scene.effects = testing::pool_effects();
        if (shot % 8 < 2) scene.effects.airborne = AirborneSpec{};
        scene.table.rails = shot % 7 != 0;
        scene.strike->elevation = shot % 5 == 0 ? 0.4 : 0;
        ASSERT_FALSE(check(scene)) << shot;
        few.simulate(scene, 0, trace);
        many.simulate(scene, 0, other);
        ASSERT_EQ(trace.hash, other.hash) << shot;
        ASSERT_EQ(trace.events, other.events) << shot;
        ASSERT_EQ(trace.balls, other.balls) << shot;
    }
}

}  // namespace
}  // namespace poolhall
