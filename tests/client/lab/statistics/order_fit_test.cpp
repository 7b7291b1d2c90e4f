#include "client/lab/statistics/order_fit.hpp"

#include "client/lab/corpora/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace poolhall::lab {
namespace {

/// The errors of a method at 15, 30, ... 7680 Hz.
template <class Error>
std::vector<ErrorAtRate> errors_of(Error error) {
    std::vector<ErrorAtRate> points;
    for (double hz = 15; hz <= 7680; hz *= 2)
        points.push_back({hz, error(hz)});
    return points;
}

TEST(LineFit, AgreesWithAWorkedExample) {
    // R: summary(lm(c(2.1, 3.9, 6.2, 7.8) ~ c(1, 2, 3, 4))): slope 1.94, standard error 0.09055
    const std::array<Point2, 4> points{{{1, 2.1}, {2, 3.9}, {3, 6.2}, {4, 7.8}}};
    const LineFit fit = fit_line(points);
    EXPECT_NEAR(fit.slope, 1.94, 1e-14);
    EXPECT_NEAR(fit.standard_error, std::sqrt(0.082 / 2 / 5), 1e-14);
}

TEST(OrderFit, FindsTheExactPowerOfCleanErrors) {
    for (const double power : {1.0, 2.0, 4.0}) {
        const auto order =
            fitted_order(errors_of([&](double hz) { return 0.3 * std::pow(hz, -power); }), 0);
        ASSERT_TRUE(order);
        EXPECT_NEAR(order->order, power, 1e-12);
        EXPECT_NEAR(order->low, power, 1e-12);
        EXPECT_NEAR(order->high, power, 1e-12);
        EXPECT_EQ(order->points, 10U);
    }
}

TEST(OrderFit, LeavesOutTheRoundingFloor) {
    const auto errors = errors_of([](double hz) { return std::max(1 / (hz * hz), 1e-6); });
    const auto order = fitted_order(errors, 1.5e-6);
    ASSERT_TRUE(order);
    EXPECT_NEAR(order->order, 2, 1e-12);
    EXPECT_EQ(order->to_hz, 480);
}

TEST(OrderFit, LeavesOutLowRatesWithoutAnError) {
    // At low rates nothing is comparable, and what is compared is equal.
    const auto order =
        fitted_order(errors_of([](double hz) { return hz < 60 ? 1e-16 : 1 / hz; }), 1e-14);
    ASSERT_TRUE(order);
    EXPECT_NEAR(order->order, 1, 1e-12);
    EXPECT_EQ(order->from_hz, 60);
}

TEST(OrderFit, LeavesOutRatesAtWhichTheErrorDoesNotYetFall) {
    // No ball is farther off than the table is long.
    const auto errors = errors_of([](double hz) { return std::min(2.0, 700 / hz); });
    const auto order = fitted_order(errors, 0);
    ASSERT_TRUE(order);
    EXPECT_NEAR(order->order, 1, 1e-12);
    EXPECT_EQ(order->from_hz, 480);
    EXPECT_EQ(order->points, 5U);
}

TEST(OrderFit, NoOrderWhereTheErrorDoesNotFall) {
    EXPECT_FALSE(fitted_order(errors_of([](double) { return 1.0; }), 0));
    EXPECT_FALSE(fitted_order(errors_of([](double hz) { return std::pow(hz, -0.2); }), 0));
}

TEST(OrderFit, NoOrderFromTooFewPoints) {
    EXPECT_FALSE(fitted_order({}, 0));
    EXPECT_FALSE(fitted_order(errors_of([](double hz) { return 1 / hz; }), 1.0 / 100));
    EXPECT_FALSE(fitted_order(errors_of([](double) { return 0.0; }), 0));
}

TEST(OrderFit, ItsIntervalHoldsTheTrueOrder95TimesInAHundred) {
    Random random(4);
    // Near enough to a normal distribution: the sum of twelve.
    const auto noise = [&random] {
        double sum = -6;
        for (int i = 0; i < 12; ++i)
            sum += random.uniform(0, 1);
        return sum;
    };
    constexpr int kTrials = 4000;
    int held = 0;
    for (int i = 0; i < kTrials; ++i) {
        const auto order =
            fitted_order(errors_of([&](double hz) { return std::exp(0.03 * noise()) / hz; }), 0);
        ASSERT_TRUE(order);
        EXPECT_EQ(order->points, 10U);
        held += order->low <= 1 && 1 <= order->high ? 1 : 0;
    }
    EXPECT_NEAR(static_cast<double>(held) / kTrials, 0.95, 0.015);
}

}  // namespace
}  // namespace poolhall::lab
