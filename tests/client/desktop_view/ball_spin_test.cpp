#include "client/desktop/view/ball_spin.hpp"

#include <gtest/gtest.h>
#include <numbers>

namespace poolhall::client {
namespace {

constexpr double kRadius = 0.028575;
constexpr double kJump = 0.4;
constexpr double kQuarterTurn = std::numbers::pi / 2 * kRadius;

void expect_near(const Vec3& a, const Vec3& b) {
    EXPECT_NEAR(a.x, b.x, 1e-9);
    EXPECT_NEAR(a.y, b.y, 1e-9);
    EXPECT_NEAR(a.z, b.z, 1e-9);
}

TEST(BallSpinTest, RollingToTheRightBringsTheTopToTheRight) {
    BallSpin spin;
    spin.follow("8", {0, 0}, kRadius, kJump);
    const Orientation& lie = spin.follow("8", {kQuarterTurn, 0}, kRadius, kJump);
    expect_near(to_ball(lie, {1, 0, 0}), {0, 0, 1});
}

TEST(BallSpinTest, RollingUpTheScreenBringsTheTopUp) {
    BallSpin spin;
    spin.follow("8", {0, 0}, kRadius, kJump);
    const Orientation& lie = spin.follow("8", {0, kQuarterTurn}, kRadius, kJump);
    expect_near(to_ball(lie, {0, 1, 0}), {0, 0, 1});
}

TEST(BallSpinTest, ManySmallStepsAreOneLargeStep) {
    BallSpin spin;
    for (int i = 0; i <= 100; ++i)
        spin.follow("cue", {kQuarterTurn * i / 100, 0}, kRadius, kJump);
    expect_near(to_ball(spin.follow("cue", {kQuarterTurn, 0}, kRadius, kJump), {1, 0, 0}),
                {0, 0, 1});
}

TEST(BallSpinTest, RollingThereAndBackEndsAsItBegan) {
    BallSpin spin;
    spin.follow("8", {0, 0}, kRadius, kJump);
    spin.follow("8", {0.07, 0.03}, kRadius, kJump);
    expect_near(to_ball(spin.follow("8", {0, 0}, kRadius, kJump), {0.6, 0, 0.8}), {0.6, 0, 0.8});
}

TEST(BallSpinTest, ABallSetDownElsewhereLiesAsAtFirst) {
    BallSpin spin;
    spin.follow("8", {0, 0}, kRadius, kJump);
    spin.follow("8", {0.03, 0}, kRadius, kJump);
    EXPECT_EQ(spin.follow("8", {0.7, 0}, kRadius, kJump), Orientation{});
}

TEST(BallSpinTest, EachBallHasItsOwn) {
    BallSpin spin;
    spin.follow("8", {0, 0}, kRadius, kJump);
    spin.follow("cue", {0.02, 0}, kRadius, kJump);
    EXPECT_EQ(spin.follow("8", {0, 0}, kRadius, kJump), Orientation{});
}

}  // namespace
}  // namespace poolhall::client
