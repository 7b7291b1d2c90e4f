#include "shared/physics/motion/cue.hpp"

#include "tests/shared/random.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace poolhall {
namespace {

constexpr double kRadius = 0.028575;
constexpr double kDegree = std::numbers::pi / 180;

Strike strike(double speed, Vec2 offset = {}, double elevation = 0, double end_mass_ratio = 0) {
    Strike one;
    one.speed = speed;
    one.offset = offset;
    one.elevation = elevation;
    one.end_mass_ratio = end_mass_ratio;
    return one;
}

Strike random_strike(testing::Random& random) {
    Strike one = strike(random.uniform(0, 10), 0.7 * random.direction(), random.uniform(0, 3),
                        random.uniform(0, 0.1));
    one.direction = random.uniform(0, 100) * random.direction();
    return one;
}

/// At which the ball's lowest point slips on the cloth.
Vec2 slip_on_cloth(const CueBallMotion& motion) {
    return {motion.v.x - kRadius * motion.w.y, motion.v.y + kRadius * motion.w.x};
}

TEST(Cue, LevelCentreHitGivesTheSpeedAlongTheDirectionAndNothingElse) {
    testing::Random random(41);
    for (int i = 0; i < 1000; ++i) {
        Strike one = strike(random.uniform(0, 10));
        one.direction = random.uniform(1e-3, 1e3) * random.direction();
        const CueBallMotion motion = strike_motion(one, kRadius);
        EXPECT_EQ(one.speed * normalized(one.direction), xy(motion.v));
        EXPECT_EQ(0, motion.v.z);
        EXPECT_FALSE(std::signbit(motion.v.z));
        EXPECT_EQ(Vec3{}, motion.w);
    }
}

// A blow at 7/5 R above the cloth makes a ball roll at once (Coriolis 1835).
TEST(Cue, FollowByTwoFifthsOfARadiusRollsAtOnce) {
    const CueBallMotion motion = strike_motion(strike(3, {0, 0.4}), kRadius);
    EXPECT_NEAR(0, norm(slip_on_cloth(motion)), 1e-15);
    EXPECT_EQ(3, motion.v.x);
}

TEST(Cue, DrawSpinsTheBallBackwards) {
    EXPECT_LT(strike_motion(strike(3, {0, -0.3}), kRadius).w.y, 0);
}

TEST(Cue, RightEnglishTurnsTheBallCounterclockwise) {
    const CueBallMotion motion = strike_motion(strike(2, {0.3, 0}), kRadius);
    EXPECT_EQ(0, motion.w.x);
    EXPECT_EQ(0, motion.w.y);
    EXPECT_DOUBLE_EQ(2.5 * 0.3 * 2 / kRadius, motion.w.z);
}

TEST(Cue, SpeedAndSpinHaveTheirSizeInEveryDirection) {
    testing::Random random(42);
    for (int i = 0; i < 2000; ++i) {
        const Strike one = random_strike(random);
        const CueBallMotion motion = strike_motion(one, kRadius);
        EXPECT_NEAR(one.speed, norm(motion.v), 1e-15 * one.speed);
        const double spin = 2.5 * norm(one.offset) * one.speed / kRadius;
        EXPECT_NEAR(spin, norm(motion.w), 2e-15 * spin);
    }
}

TEST(Cue, SpinIsSquareToTheCue) {
    testing::Random random(43);
    for (int i = 0; i < 2000; ++i) {
        Strike one = random_strike(random);
        one.end_mass_ratio = 0;
        const CueBallMotion motion = strike_motion(one, kRadius);
        EXPECT_NEAR(0, dot(motion.v, motion.w), 1e-15 * norm(motion.v) * norm(motion.w));
    }
}

TEST(Cue, ElevatedCueDrivesTheBallIntoTheSlate) {
    const CueBallMotion motion = strike_motion(strike(5, {}, 0.75), kRadius);
    EXPECT_DOUBLE_EQ(4, motion.v.x);
    EXPECT_DOUBLE_EQ(-3, motion.v.z);
}

// The cloth pushes against the slip: towards the side of the english (swerve, masse).
TEST(Cue, ElevatedCueMakesEnglishSwerveToItsSide) {
    EXPECT_GT(slip_on_cloth(strike_motion(strike(5, {0.3, 0}, 0.5), kRadius)).y, 0);
    EXPECT_LT(slip_on_cloth(strike_motion(strike(5, {-0.3, 0}, 0.5), kRadius)).y, 0);
    EXPECT_EQ(0, slip_on_cloth(strike_motion(strike(5, {0.3, 0}), kRadius)).y);
}

TEST(Cue, MirroredStrikesGiveMirroredMotionToTheBit) {
    testing::Random random(44);
    for (int i = 0; i < 1000; ++i) {
        const Strike one = random_strike(random);
        Strike other = one;
        other.direction.y = -one.direction.y;
        other.offset.x = -one.offset.x;
        const CueBallMotion expected = strike_motion(one, kRadius);
        const CueBallMotion motion = strike_motion(other, kRadius);
        EXPECT_EQ((Vec3{expected.v.x, -expected.v.y, expected.v.z}), motion.v);
        EXPECT_EQ((Vec3{-expected.w.x, expected.w.y, -expected.w.z}), motion.w);
    }
}

// The number of pooltool's test of its squirt model (tests/physics/resolve/ball_stick), which is
// TP A.31 with a ball 20 times as heavy as the cue's end.
TEST(Squirt, AgreesWithPooltool) {
    EXPECT_NEAR(1.1993583313332898, std::atan(squirt_tangent(0.2, 0.05)) / kDegree, 1e-14);
}

TEST(Squirt, GoesAwayFromTheEnglish) {
    EXPECT_GT(strike_motion(strike(2, {0.3, 0}, 0, 0.05), kRadius).v.y, 0);
    EXPECT_LT(strike_motion(strike(2, {-0.3, 0}, 0, 0.05), kRadius).v.y, 0);
    EXPECT_EQ(0, strike_motion(strike(2, {0, 0.3}, 0, 0.05), kRadius).v.y);
}

// What TP A.31 starts from: the tip does not slip, so that the end of the cue and the ball's
// surface move sideways together, with opposite momenta of the cue's end and the ball.
TEST(Squirt, TipAndSurfaceMoveSidewaysTogether) {
    for (const double side : {-0.5, -0.1, 0.2, 0.6}) {
        const double ratio = 0.06;
        const double depth = std::sqrt(1 - side * side);
        const double sideways = squirt_tangent(side, ratio);  // of the ball, for 1 m/s forward
        const double turn = 2.5 * (side - depth * sideways);  // R w by that very impulse
        EXPECT_NEAR(-sideways / ratio, sideways - depth * turn, 1e-15);
    }
}

TEST(Squirt, IsNoneWithoutEndMass) {
    testing::Random random(45);
    for (int i = 0; i < 100; ++i) {
        Strike one = random_strike(random);
        one.end_mass_ratio = 0;
        Strike centre = one;
        centre.offset = {};
        EXPECT_EQ(strike_motion(centre, kRadius).v, strike_motion(one, kRadius).v);
    }
}

TEST(Cue, DirectionsOfAnyLengthAreTheSame) {
    const CueBallMotion expected = strike_motion(strike(2, {0.1, 0.2}, 0.3, 0.05), kRadius);
    for (const double length : {5e-324, 1e-200, 1e200, 1.7e308}) {
        Strike one = strike(2, {0.1, 0.2}, 0.3, 0.05);
        one.direction = {length, 0};
        EXPECT_EQ(expected.v, strike_motion(one, kRadius).v);
        EXPECT_EQ(expected.w, strike_motion(one, kRadius).w);
    }
}

TEST(Cue, SteepestCueStrikesStraightDown) {
    const CueBallMotion motion = strike_motion(strike(2, {0.1, 0.2}, 1e300), kRadius);
    EXPECT_EQ(-2, motion.v.z);
    EXPECT_NEAR(0, motion.v.x, 1e-299);
    EXPECT_TRUE(std::isfinite(norm(motion.w)));
}

TEST(Cue, NoSpeedGivesNoMotion) {
    const CueBallMotion motion = strike_motion(strike(0, {0.3, 0.3}, 0.2, 0.05), kRadius);
    EXPECT_EQ(Vec3{}, motion.v);
    EXPECT_EQ(Vec3{}, motion.w);
}

constexpr BallSpec kBall{kRadius, 0.17};

TEST(Cue, OfAPlainKindSendsTheBallOffAtFourThirdsOfItsSpeed) {
    Strike one = strike(2);
    one.cue = preset_value(CuePreset::kPlain);
    const Strike felt = strike_of_ball(one, kBall);
    EXPECT_FALSE(felt.cue);
    EXPECT_NEAR(2 * 1.73 / (1 + 0.17 / 0.5386), felt.speed, 1e-15);
    EXPECT_NEAR(1.315, felt.speed / 2, 1e-3);
    EXPECT_NEAR(0.05, felt.end_mass_ratio, 1e-15);
    one.end_mass_ratio = 0.03;
    EXPECT_EQ(0.03, strike_of_ball(one, kBall).end_mass_ratio);
}

TEST(Cue, WithAHardTipGivesMoreAndALighterBallMore) {
    Strike one = strike(2);
    one.cue = preset_value(CuePreset::kBreak);
    EXPECT_NEAR(1.398, strike_of_ball(one, kBall).speed / 2, 1e-3);
    EXPECT_GT(strike_of_ball(one, {kRadius, 0.14}).speed, strike_of_ball(one, kBall).speed);
}

TEST(Cue, TouchesNearerToTheMiddleThanItsAxisPoints) {
    Strike one = strike(2, {0.3, -0.4});
    one.cue.emplace();
    const Strike felt = strike_of_ball(one, kBall);
    const double nearer = kRadius / (kRadius + one.cue->tip_radius);
    EXPECT_NEAR(0.5 * nearer, norm(felt.offset), 1e-15);
    EXPECT_NEAR(0, cross(one.offset, felt.offset), 1e-15);
    one.cue->tip_radius = 0;
    EXPECT_EQ(one.offset, strike_of_ball(one, kBall).offset);
}

// Momentum of cue and ball, spin of the ball, and at the point of contact along the cue the
// relative speed times -e.
TEST(Cue, ObeysRestitutionWhereItTouches) {
    testing::Random random(43);
    for (int i = 0; i < 1000; ++i) {
        Strike one = strike(random.uniform(0.1, 10), random.uniform(0, 0.6) * random.direction());
        one.cue = CueSpec{random.uniform(0.3, 0.7), random.uniform(0, 1), 0, 0};
        const Strike felt = strike_of_ball(one, kBall);
        const CueBallMotion motion = strike_motion(felt, kRadius);
        const double cue_after = one.speed - kBall.mass / one.cue->mass * felt.speed;
        const Vec3 tip = kRadius * Vec3{0, -felt.offset.x, felt.offset.y};
        const double surface = motion.v.x + cross(motion.w, tip).x;
        EXPECT_NEAR(one.cue->e * one.speed, surface - cue_after, 1e-13 * one.speed);
    }
}

TEST(Cue, AbsentLeavesTheStrikeAsItIs) {
    const Strike one = strike(2, {0.3, -0.4}, 0.1, 0.05);
    EXPECT_EQ(one, strike_of_ball(one, kBall));
}

}  // namespace
}  // namespace poolhall
