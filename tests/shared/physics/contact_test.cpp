#include "shared/physics/contact/contact.hpp"

#include "tests/shared/contacts.hpp"
#include "tests/shared/reference.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace poolhall {
namespace {

constexpr double kDiameter = 2 * BallSpec{}.radius;
const double kRootThree = std::sqrt(3.0);

MovingBall ball_at(Vec2 r, Vec2 v = {}) {
    MovingBall ball;
    ball.r = r;
    ball.v = v;
    ball.radius = BallSpec{}.radius;
    ball.mass = BallSpec{}.mass;
    return ball;
}

TEST(Contact, ElasticPairAgreesWithTheReference) {
    for (const auto& one : testing::reference_cases("c_collision")) {
        if (one.input("e") != 1) continue;
        SCOPED_TRACE(one.id);
        const Vec2 n{one.expected("n", 0), one.expected("n", 1)};
        std::vector<MovingBall> balls{ball_at({}, {one.input("v0"), 0}), ball_at(kDiameter * n)};
        ASSERT_TRUE(testing::resolve_contacts({ball_contact(0, 1)}, 1, balls));
        EXPECT_NEAR(one.expected("v_obj", 0), balls[1].v.x, 1e-15);
        EXPECT_NEAR(one.expected("v_obj", 1), balls[1].v.y, 1e-15);
        EXPECT_NEAR(one.expected("v_cue", 0), balls[0].v.x, 1e-15);
        EXPECT_NEAR(one.expected("v_cue", 1), balls[0].v.y, 1e-15);
    }
}

TEST(Contact, HeadOnPairExchangesVelocities) {
    std::vector<MovingBall> balls{ball_at({}, {0.1, 0}), ball_at({kDiameter, 0}, {-7.3, 0})};
    ASSERT_TRUE(testing::resolve_contacts({ball_contact(0, 1)}, 1, balls));
    EXPECT_NEAR(-7.3, balls[0].v.x, 4e-15);
    EXPECT_NEAR(0.1, balls[1].v.x, 4e-15);
    EXPECT_EQ(0, balls[0].v.y);
    EXPECT_EQ(0, balls[1].v.y);
}

TEST(Contact, RailTurnsOnlyTheNormalVelocity) {
    std::vector<MovingBall> balls{ball_at({}, {1.5, 2.5})};
    ASSERT_TRUE(testing::resolve_contacts({rail_contact(0, Rail::kNorth)}, 0.5, balls));
    EXPECT_EQ((Vec2{1.5, -1.25}), balls[0].v);
    balls[0].v = {-1.5, 2.5};
    ASSERT_TRUE(testing::resolve_contacts({rail_contact(0, Rail::kWest)}, 0.5, balls));
    EXPECT_EQ((Vec2{0.75, 2.5}), balls[0].v);
}

TEST(Contact, CornerTurnsBothWhicheverRailComesFirst) {
    for (const bool north_first : {true, false}) {
        std::vector<MovingBall> balls{ball_at({}, {1.3, 0.7})};
        std::vector<Contact> contacts{rail_contact(0, Rail::kNorth), rail_contact(0, Rail::kEast)};
        if (!north_first) std::swap(contacts[0], contacts[1]);
        ASSERT_TRUE(testing::resolve_contacts(contacts, 1, balls));
        EXPECT_EQ((Vec2{-1.3, -0.7}), balls[0].v);
    }
}

/// Cue ball into two touching balls at once.
std::vector<MovingBall> wedge() {
    const Vec2 north = kDiameter * Vec2{kRootThree / 2, 0.5};
    return {ball_at({}, {1, 0}), ball_at(north), ball_at({north.x, -north.y})};
}

TEST(Contact, SymmetricDoubleHitIsExactlyAMirrorImage) {
    std::vector<MovingBall> balls = wedge();
    ASSERT_TRUE(testing::resolve_contacts({ball_contact(0, 1), ball_contact(0, 2)}, 1, balls));
    EXPECT_NEAR(-0.2, balls[0].v.x, 1e-14);
    EXPECT_EQ(0, balls[0].v.y);
    EXPECT_NEAR(2 * kRootThree / 5, norm(balls[1].v), 1e-14);
    EXPECT_EQ(balls[1].v.x, balls[2].v.x);
    EXPECT_EQ(balls[1].v.y, -balls[2].v.y);
}

TEST(Contact, OrderOfTheContactsLeavesNoTrace) {
    std::vector<MovingBall> balls = wedge();
    balls[0].v = {1, 0.1234};
    balls.push_back(ball_at({-kDiameter * 0.6, kDiameter * 0.8}, {0.3, -2}));
    std::vector<Contact> contacts{ball_contact(0, 1), ball_contact(0, 2), ball_contact(0, 3)};
    std::vector<MovingBall> first = balls;
    ASSERT_TRUE(testing::resolve_contacts(contacts, 1, first));
    while (std::next_permutation(contacts.begin(), contacts.end(),
                                 [](const Contact& c, const Contact& d) { return c.b < d.b; })) {
        std::vector<MovingBall> again = balls;
        ASSERT_TRUE(testing::resolve_contacts(contacts, 1, again));
        for (std::size_t i = 0; i < balls.size(); ++i)
            EXPECT_EQ(first[i].v, again[i].v);
    }
}

TEST(Contact, BallPinchedBetweenTwoBallsKeepsMomentumAndEnergy) {
    std::vector<MovingBall> balls{ball_at({-kDiameter, 0}, {2, 0}), ball_at({}),
                                  ball_at({kDiameter, 0}, {-3, 0.5})};
    ASSERT_TRUE(testing::resolve_contacts({ball_contact(0, 1), ball_contact(1, 2)}, 1, balls));
    const Vec2 momentum = balls[0].v + balls[1].v + balls[2].v;
    EXPECT_NEAR(-1, momentum.x, 1e-15);
    EXPECT_NEAR(0.5, momentum.y, 4e-16);
    const double energy =
        dot(balls[0].v, balls[0].v) + dot(balls[1].v, balls[1].v) + dot(balls[2].v, balls[2].v);
    EXPECT_NEAR(4 + 9.25, energy, 1e-14);
    EXPECT_LE(balls[0].v.x, balls[1].v.x + 1e-12);
    EXPECT_LE(balls[1].v.x, balls[2].v.x + 1e-12);
}

TEST(Contact, BallPressedIntoARailByAnotherLeavesBothApproachingNothing) {
    std::vector<MovingBall> balls{ball_at({0, -kDiameter}, {0, 1}), ball_at({}, {0, 0.5})};
    ASSERT_TRUE(
        testing::resolve_contacts({ball_contact(0, 1), rail_contact(1, Rail::kNorth)}, 1, balls));
    EXPECT_LE(balls[1].v.y, 1e-12) << "not into the rail";
    EXPECT_GE(balls[1].v.y - balls[0].v.y, -1e-12) << "not into each other";
    EXPECT_NEAR(1.25, dot(balls[0].v, balls[0].v) + dot(balls[1].v, balls[1].v), 1e-14);
}

TEST(Contact, ShrinkingSquareGrowsAgain) {
    // Four balls in a square that shrinks: four contacts, every ball in two of them.
    std::vector<MovingBall> balls{ball_at({0, 0}, {1, 1}), ball_at({kDiameter, 0}, {-1, 1}),
                                  ball_at({kDiameter, kDiameter}, {-1, -1}),
                                  ball_at({0, kDiameter}, {1, -1})};
    ASSERT_TRUE(testing::resolve_contacts(
        {ball_contact(0, 1), ball_contact(1, 2), ball_contact(2, 3), ball_contact(0, 3)}, 1,
        balls));
    for (const MovingBall& ball : balls)
        EXPECT_NEAR(2, dot(ball.v, ball.v), 1e-14);
    EXPECT_NEAR(-1, balls[0].v.x, 1e-14);
    EXPECT_NEAR(-1, balls[0].v.y, 1e-14);
}

}  // namespace
}  // namespace poolhall
