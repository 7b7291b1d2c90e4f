#include "shared/physics/search/free_boxes.hpp"

#include <gtest/gtest.h>

namespace poolhall {
namespace {

constexpr double kRadius = 0.5;

std::vector<std::size_t> near(const FreeBoxes& boxes, std::size_t ball) {
    std::vector<std::size_t> found;
    boxes.for_each_near(ball, [&](std::size_t other) { found.push_back(other); });
    return found;
}

class TwoBalls : public ::testing::Test {
  protected:
    TwoBalls() { boxes.reset(2, {-10, 10, -10, 10}, 24); }

    FreeBoxes boxes;
};

TEST_F(TwoBalls, BallHasNoBoxBeforeItClaimsOne) {
    EXPECT_TRUE(boxes.is_loose(0));
    EXPECT_FALSE(boxes.holds(0, {0, 0}));
    EXPECT_TRUE(boxes.claim(0, {0, 2, 0, 0}, kRadius));
    EXPECT_FALSE(boxes.is_loose(0));
    EXPECT_TRUE(boxes.holds(0, {2, 0}));
    EXPECT_FALSE(boxes.holds(0, {2, 0.1}));
}

TEST_F(TwoBalls, BoxIsNotGivenWhereAnotherBallCouldBeTouched) {
    boxes.settle(1, {3, 0}, kRadius);
    EXPECT_FALSE(boxes.claim(0, {0, 2, 0, 0}, kRadius));
    EXPECT_TRUE(boxes.is_loose(0));
    EXPECT_TRUE(boxes.claim(0, {0, 1.9, 0, 0}, kRadius));
}

TEST_F(TwoBalls, BallThatComesToRestInABoxTakesItAway) {
    ASSERT_TRUE(boxes.claim(0, {0, 9, 0, 0}, kRadius));
    boxes.sweep(1, {5, 2}, {5, 0.5}, kRadius);
    EXPECT_FALSE(boxes.is_loose(0));
    boxes.settle(1, {5, 0.5}, kRadius);
    EXPECT_TRUE(boxes.is_loose(0));
    EXPECT_TRUE(boxes.holds(1, {5, 0.5}));
}

TEST_F(TwoBalls, BallsAtRestThatTouchKeepTheirPlaces) {
    boxes.settle(0, {0, 0}, kRadius);
    boxes.settle(1, {1, 0}, kRadius);
    EXPECT_FALSE(boxes.is_loose(0));
    EXPECT_FALSE(boxes.is_loose(1));
    boxes.wake(0);
    EXPECT_TRUE(boxes.is_loose(0));
    EXPECT_FALSE(boxes.is_loose(1));
}

TEST_F(TwoBalls, SweptBallIsNearWhatItPasses) {
    boxes.settle(1, {5, 0.9}, kRadius);
    boxes.sweep(0, {0, 0}, {4, 0}, kRadius);
    EXPECT_EQ(std::vector<std::size_t>{1}, near(boxes, 0));
    boxes.sweep(0, {0, 0}, {3.9, 0}, kRadius);
    EXPECT_EQ(std::vector<std::size_t>{}, near(boxes, 0));
    boxes.sweep(0, {0, 0}, {9, 0}, kRadius);
    boxes.remove(1);
    EXPECT_EQ(std::vector<std::size_t>{}, near(boxes, 0));
}

}  // namespace
}  // namespace poolhall
