#include "shared/physics/contact/ball_friction.hpp"
#include "tests/shared/physics/friction_impacts.hpp"
#include "tests/shared/random.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace poolhall {
namespace {

using namespace testing;

Vec3 random_vector(testing::Random& random, double size) {
    return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

ImpactBall random_ball(testing::Random& random) {
    return {.v = random_vector(random, 5),
            .w = random_vector(random, 150),
            .radius = random.uniform(0.02, 0.04),
            .mass = random.uniform(0.05, 0.4)};
}

Vec3 random_normal(testing::Random& random) {
    const Vec3 n = random_vector(random, 1);
    return 1 / norm(n) * n;
}

Vec3 momentum(const ImpactBall& a, const ImpactBall& b) {
    return a.mass * a.v + b.mass * b.v;
}

double inertia(const ImpactBall& one) {
    return 0.4 * one.mass * one.radius * one.radius;
}

/// About the point where they touch.
Vec3 angular_momentum(Vec3 n, const ImpactBall& a, const ImpactBall& b) {
    return (inertia(a) * a.w - a.mass * a.radius * cross(n, a.v)) +
           (inertia(b) * b.w + b.mass * b.radius * cross(n, b.v));
}

double energy(const ImpactBall& one) {
    return 0.5 * (one.mass * dot(one.v, one.v) + inertia(one) * dot(one.w, one.w));
}

/// A random impact of unequal balls in space, friction and all.
struct Impact {
    Vec3 n;
    ImpactBall a, b;

    explicit Impact(testing::Random& random)
        : n(random_normal(random)), a(random_ball(random)), b(random_ball(random)) {}

    [[nodiscard]] double normal() const { return std::abs(normal_impulse(0.9, n, a, b)); }
};

TEST(BallFriction, KeepsMomentumAndAngularMomentumOfUnequalBalls) {
    testing::Random random(32);
    for (int i = 0; i < 2000; ++i) {
        Impact impact(random);
        const Vec3 before = momentum(impact.a, impact.b);
        const Vec3 turning = angular_momentum(impact.n, impact.a, impact.b);
        apply_friction_in_air(by_speed(), impact.normal(), impact.n, impact.a, impact.b);
        EXPECT_LE(norm(momentum(impact.a, impact.b) - before), 4e-16 * 5);
        EXPECT_LE(norm(angular_momentum(impact.n, impact.a, impact.b) - turning), 4e-16);
    }
}

TEST(BallFriction, NeverRaisesTheEnergy) {
    testing::Random random(33);
    for (int i = 0; i < 4000; ++i) {
        Impact impact(random);
        const bool level = i % 2 == 0;
        if (level) impact.a.v.z = impact.b.v.z = 0;
        const double before = energy(impact.a) + energy(impact.b);
        const auto apply = level ? apply_friction : apply_friction_in_air;
        apply(constant(random.uniform(0, 2)), impact.normal(), impact.n, impact.a, impact.b);
        EXPECT_LE(energy(impact.a) + energy(impact.b), before * (1 + 4e-16));
    }
}

TEST(BallFriction, SlowsTheSlipAndNeverTurnsItRound) {
    testing::Random random(34);
    for (int i = 0; i < 2000; ++i) {
        Impact impact(random);
        const Vec3 before = slip_velocity(impact.n, impact.a, impact.b);
        apply_friction_in_air(by_speed(), impact.normal(), impact.n, impact.a, impact.b);
        const Vec3 after = slip_velocity(impact.n, impact.a, impact.b);
        EXPECT_GE(dot(before, after), -1e-14 * dot(before, before));
        EXPECT_LT(norm(after), norm(before));
        EXPECT_LE(norm(cross(before, after)), 1e-14 * dot(before, before));
    }
}

TEST(BallFriction, EndsTheSlipOfAnyBallsWhereItIsStrongEnough) {
    testing::Random random(35);
    for (int i = 0; i < 2000; ++i) {
        Impact impact(random);
        apply_friction_in_air(constant(1e9), 1, impact.n, impact.a, impact.b);
        EXPECT_LE(norm(slip_velocity(impact.n, impact.a, impact.b)), 1e-14);
    }
}

TEST(BallFriction, EqualBallsShareASeventhOfTheSlip) {
    ImpactBall cue = ball({0, 0.7, 0}, {});
    ImpactBall object = ball();
    apply_friction(constant(1e9), 1, {1, 0, 0}, cue, object);
    EXPECT_NEAR(0.6, cue.v.y, 1e-15);
    EXPECT_NEAR(0.1, object.v.y, 1e-15);
}

TEST(BallFriction, OnTheClothTheSlateTakesTheVerticalImpulse) {
    ImpactBall cue = ball({1, 0, 0}, {0, 1 / kRadius, 0});
    ImpactBall object = ball();
    ImpactBall lifted_cue = cue;
    ImpactBall pressed_object = object;
    apply_friction(constant(0.05), kMass, {1, 0, 0}, cue, object);
    apply_friction_in_air(constant(0.05), kMass, {1, 0, 0}, lifted_cue, pressed_object);
    EXPECT_EQ(0, cue.v.z);
    EXPECT_EQ(0, object.v.z);
    EXPECT_NEAR(0.05, lifted_cue.v.z, 1e-15);
    EXPECT_NEAR(-0.05, pressed_object.v.z, 1e-15);
    EXPECT_EQ(lifted_cue.w, cue.w);
    EXPECT_EQ(pressed_object.w, object.w);
}

TEST(BallFriction, BallsHaveNoOrder) {
    testing::Random random(36);
    for (int i = 0; i < 1000; ++i) {
        const Impact impact(random);
        Impact one = impact;
        Impact other = impact;
        apply_friction(by_speed(), impact.normal(), impact.n, one.a, one.b);
        apply_friction(by_speed(), impact.normal(), -impact.n, other.b, other.a);
        EXPECT_EQ(one.a.v, other.a.v);
        EXPECT_EQ(one.a.w, other.a.w);
        EXPECT_EQ(one.b.v, other.b.v);
        EXPECT_EQ(one.b.w, other.b.w);
    }
}

/// In the plane y = 0; spins are no arrows, they keep what arrows lose.
Vec3 mirrored(Vec3 arrow) {
    return {arrow.x, -arrow.y, arrow.z};
}

ImpactBall mirrored(ImpactBall one) {
    one.v = mirrored(one.v);
    one.w = -mirrored(one.w);
    return one;
}

TEST(BallFriction, MirroredImpactsGiveMirroredResultsToTheBit) {
    testing::Random random(37);
    for (int i = 0; i < 1000; ++i) {
        Impact impact(random);
        ImpactBall a = mirrored(impact.a);
        ImpactBall b = mirrored(impact.b);
        apply_friction(by_speed(), impact.normal(), mirrored(impact.n), a, b);
        apply_friction(by_speed(), impact.normal(), impact.n, impact.a, impact.b);
        EXPECT_EQ(mirrored(impact.a).v, a.v);
        EXPECT_EQ(mirrored(impact.a).w, a.w);
        EXPECT_EQ(mirrored(impact.b).v, b.v);
        EXPECT_EQ(mirrored(impact.b).w, b.w);
    }
}

}  // namespace
}  // namespace poolhall
