#include "client/lab/statistics/quantiles.hpp"

#include <array>
#include <gtest/gtest.h>
#include <limits>

namespace poolhall::lab {
namespace {

TEST(Quantile, IsLinearBetweenNeighboursAsInR) {
    // R: quantile(c(1, 2, 4, 8), c(0, 0.1, 0.5, 0.9, 1))
    const std::array values{1.0, 2.0, 4.0, 8.0};
    EXPECT_DOUBLE_EQ(quantile(values, 0), 1);
    EXPECT_DOUBLE_EQ(quantile(values, 0.1), 1.3);
    EXPECT_DOUBLE_EQ(quantile(values, 0.5), 3);
    EXPECT_DOUBLE_EQ(quantile(values, 0.9), 6.8);
    EXPECT_DOUBLE_EQ(quantile(values, 1), 8);
}

TEST(Quantile, OfOneNumberIsThatNumber) {
    EXPECT_EQ(quantile(std::array{7.0}, 0.9), 7);
}

TEST(Spread, SortsFirst) {
    EXPECT_EQ(spread_of({3, 1, 2}), (Spread{2, 2.8, 3}));
    EXPECT_EQ(spread_of({5, 1, 4, 2, 3, 11, 8, 7, 6, 10, 9}), (Spread{6, 10, 11}));
}

TEST(Spread, OfNothingIsNothing) {
    EXPECT_FALSE(spread_of({}));
}

TEST(Spread, KeepsInfinityWhereItBelongs) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(spread_of({kInfinity, 1, 2}), (Spread{2, kInfinity, kInfinity}));
    EXPECT_EQ(spread_of({kInfinity, kInfinity, kInfinity})->median, kInfinity);
}

}  // namespace
}  // namespace poolhall::lab
