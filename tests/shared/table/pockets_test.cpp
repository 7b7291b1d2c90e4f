#include "shared/table/pockets.hpp"

#include "shared/game/end_game.hpp"
#include "tests/shared/random.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace poolhall {
namespace {

constexpr double kRadius = BallSpec{}.radius;
const Table kTable{end_game::kLength, end_game::kWidth, true, PocketModel::kEndGame};
const EndGamePocketMap kMap(kTable, kRadius);
const Vec2 kEdge = inset(kTable, kRadius);

TEST(EndGamePockets, BallAtTwoRailsIsInTheCorner) {
    EXPECT_EQ(Pocket::kNorthEast, kMap.at(kEdge));
    EXPECT_EQ(Pocket::kNorthWest, kMap.at({-kEdge.x, kEdge.y}));
    EXPECT_EQ(Pocket::kSouthEast, kMap.at({kEdge.x, -kEdge.y}));
    EXPECT_EQ(Pocket::kSouthWest, kMap.at(-kEdge));
}

TEST(EndGamePockets, BallAtTheMiddleOfALongRailIsInTheCentrePocket) {
    EXPECT_EQ(Pocket::kNorth, kMap.at({0, kEdge.y}));
    EXPECT_EQ(Pocket::kSouth, kMap.at({0, -kEdge.y}));
    EXPECT_EQ(Pocket::kNorth, kMap.at({0.75 * kRadius, kEdge.y}));
    EXPECT_FALSE(kMap.at({0.76 * kRadius, kEdge.y}));
}

TEST(EndGamePockets, OneAndAHalfRadiiFromBothRailsIsTheLimit) {
    const double x = kTable.length / 2 - 1.5 * kRadius;
    const double y = kTable.width / 2 - 1.5 * kRadius;
    EXPECT_TRUE(kMap.at({x, y}));
    EXPECT_FALSE(kMap.at({std::nextafter(x, 0), y}));
    EXPECT_FALSE(kMap.at({x, std::nextafter(y, 0)}));
}

TEST(EndGamePockets, TakeNoBallAwayFromTheRails) {
    EXPECT_FALSE(kMap.at({0, 0}));
    EXPECT_FALSE(kMap.at({kEdge.x, 0}));
    EXPECT_FALSE(kMap.at({kEdge.x / 2, kEdge.y}));
}

TEST(EndGamePockets, MouthsAreOnTheRailsWhereTheirPocketsCapture) {
    for (int i = 0; i < kPocketCount; ++i) {
        const auto pocket = static_cast<Pocket>(i);
        const Vec2 mouth = EndGamePocketMap::mouth(kTable, pocket);
        EXPECT_EQ(kTable.width / 2, std::abs(mouth.y));
        EXPECT_EQ(pocket, kMap.at(mouth));
    }
}

TEST(EndGamePockets, FirstCaptureIsWhereTheWayFirstEntersAPocket) {
    testing::Random random(1);
    int captures = 0;
    for (int i = 0; i < 3000; ++i) {
        const Vec2 r{random.uniform(-kEdge.x, kEdge.x), random.uniform(-kEdge.y, kEdge.y)};
        const Vec2 v = random.uniform(0.1, 3) * random.direction();
        constexpr double kTime = 0.5;
        constexpr int kSteps = 2000;
        const auto capture = kMap.first_capture(r, v, kTime);
        for (int step = 0; step <= kSteps; ++step) {
            const double t = kTime * step / kSteps;
            const auto there = kMap.at(r + t * v);
            if (!there) continue;
            ASSERT_TRUE(capture) << i;
            EXPECT_LE(capture->t, t + 1e-12);
            EXPECT_GE(capture->t, t - 1.01 * kTime / kSteps);
            EXPECT_EQ(*there, capture->pocket);
            break;
        }
        if (!capture) continue;
        ++captures;
        EXPECT_LE(capture->t, kTime);
        // A hair inside, whatever the rounding.
        EXPECT_EQ(capture->pocket, kMap.at(r + (capture->t + 1e-9) * v));
    }
    EXPECT_GT(captures, 300);
}

TEST(EndGamePockets, BallThatStartsInAPocketIsCapturedAtOnce) {
    const auto capture = kMap.first_capture(kEdge, {-1, 0}, 1);
    ASSERT_TRUE(capture);
    EXPECT_EQ(0, capture->t);
    EXPECT_EQ(Pocket::kNorthEast, capture->pocket);
}

TEST(EndGamePockets, CaptureIsMirroredExactly) {
    testing::Random random(2);
    for (int i = 0; i < 2000; ++i) {
        const Vec2 r{random.uniform(-kEdge.x, kEdge.x), random.uniform(-kEdge.y, kEdge.y)};
        const Vec2 v = random.direction();
        const auto capture = kMap.first_capture(r, v, 1);
        const auto in_x = kMap.first_capture({-r.x, r.y}, {-v.x, v.y}, 1);
        const auto in_y = kMap.first_capture({r.x, -r.y}, {v.x, -v.y}, 1);
        ASSERT_EQ(capture.has_value(), in_x.has_value());
        ASSERT_EQ(capture.has_value(), in_y.has_value());
        if (!capture) continue;
        EXPECT_EQ(capture->t, in_x->t);
        EXPECT_EQ(capture->t, in_y->t);
    }
}

}  // namespace
}  // namespace poolhall
