#include "shared/math/elementary.hpp"

#include "tests/shared/quad.hpp"
#include "tests/shared/random.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace poolhall {
namespace {

using testing::Quad;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr int kSamples = 5000;

/// e^x - 1 by its series at x / 2^10, then ten doublings; |x| < 1000, relative error about 2^-102.
Quad exact_expm1(Quad x) {
    const Quad part = x / 1024;
    Quad sum = 0;
    for (int n = 30; n > 0; --n)
        sum = (1 + sum) * part / n;
    for (int i = 0; i < 10; ++i)
        sum *= 2 + sum;
    return sum;
}

Quad exact_exp(Quad x) {
    return x < 0 ? 1 / (1 + exact_expm1(-x)) : 1 + exact_expm1(x);
}

/// log(1 + x): Halley's steps from a double's logarithm.
Quad exact_log1p(Quad x) {
    Quad y = std::log1p(testing::to_double(x));
    for (int i = 0; i < 3; ++i) {
        const Quad e = exact_expm1(y);
        y += 2 * (x - e) / (x + e + 2);
    }
    return y;
}

/// |actual - exact| in units of the last place of the exact value.
double ulps(double actual, Quad exact) {
    const double size = std::abs(testing::to_double(exact));
    const double ulp = std::nextafter(size, kInfinity) - size;
    return testing::to_double(testing::abs((Quad{actual} - exact) / ulp));
}

/// A number whose logarithm is uniform between those of 2^low and 2^high, of either sign.
double any_size(testing::Random& random, int low, int high) {
    const auto spread = static_cast<std::size_t>(high - low);
    const int exponent = low + static_cast<int>(random.below(spread));
    return std::ldexp(random.uniform(1, 2) * (random.below(2) == 0 ? 1 : -1), exponent);
}

TEST(Elementary, ExpIsWithinAnUlp) {
    testing::Random random(11);
    double worst = 0;
    for (int i = 0; i < kSamples; ++i) {
        const double wide = random.uniform(-708, 709.7);
        const double near = any_size(random, -60, 1);
        worst = std::max(worst, ulps(elementary::exp(wide), exact_exp(wide)));
        worst = std::max(worst, ulps(elementary::exp(near), exact_exp(near)));
    }
    EXPECT_LE(worst, 0.55);
}

TEST(Elementary, SubnormalExpIsWithinAnUlpOfItsOwn) {
    testing::Random random(15);
    double worst = 0;
    for (int i = 0; i < kSamples; ++i) {
        const double x = random.uniform(-745, -708.4);
        worst = std::max(worst, ulps(elementary::exp(x), exact_exp(x)));
    }
    EXPECT_LE(worst, 0.8);
}

TEST(Elementary, Expm1IsWithinAnUlp) {
    testing::Random random(12);
    double worst = 0;
    for (int i = 0; i < kSamples; ++i) {
        const double wide = random.uniform(-60, 709.7);
        const double near = any_size(random, -1000, 1);
        worst = std::max(worst, ulps(elementary::expm1(wide), exact_expm1(wide)));
        worst = std::max(worst, ulps(elementary::expm1(near), exact_expm1(near)));
    }
    EXPECT_LE(worst, 0.6);
}

TEST(Elementary, LogIsWithinAnUlp) {
    testing::Random random(13);
    double worst = 0;
    for (int i = 0; i < kSamples; ++i) {
        const double wide = std::abs(any_size(random, -1074, 1024));
        const double near = 1 + any_size(random, -52, -2);
        worst = std::max(worst, ulps(elementary::log(wide), exact_log1p(Quad{wide} - 1)));
        if (near == 1) continue;
        worst = std::max(worst, ulps(elementary::log(near), exact_log1p(Quad{near} - 1)));
    }
    EXPECT_LE(worst, 0.65);
}

TEST(Elementary, Log1pIsWithinAnUlp) {
    testing::Random random(14);
    double worst = 0;
    for (int i = 0; i < kSamples; ++i) {
        const double near = any_size(random, -1000, 0) / 2;
        const double wide = std::abs(any_size(random, -1, 1024));
        worst = std::max(worst, ulps(elementary::log1p(near), exact_log1p(near)));
        worst = std::max(worst, ulps(elementary::log1p(wide), exact_log1p(wide)));
    }
    EXPECT_LE(worst, 0.6);
}

TEST(Elementary, IsExactWhereTheResultIsExact) {
    EXPECT_EQ(1, elementary::exp(0));
    EXPECT_EQ(0, elementary::expm1(0));
    EXPECT_EQ(0, elementary::log(1));
    EXPECT_EQ(0, elementary::log1p(0));
    EXPECT_EQ(5e-324, elementary::expm1(5e-324));
    EXPECT_EQ(-5e-324, elementary::log1p(-5e-324));
}

TEST(Elementary, GoesToInfinityAndToZeroAtTheEndsOfItsRange) {
    EXPECT_EQ(kInfinity, elementary::exp(709.79));
    EXPECT_EQ(kInfinity, elementary::exp(kInfinity));
    EXPECT_EQ(5e-324, elementary::exp(-745.13));
    EXPECT_EQ(0, elementary::exp(-745.14));
    EXPECT_EQ(0, elementary::exp(-kInfinity));
    EXPECT_EQ(kInfinity, elementary::expm1(709.79));
    EXPECT_EQ(-1, elementary::expm1(-1e300));
    EXPECT_EQ(-1, elementary::expm1(-kInfinity));
    EXPECT_EQ(-kInfinity, elementary::log(0));
    EXPECT_EQ(kInfinity, elementary::log(kInfinity));
    EXPECT_EQ(-kInfinity, elementary::log1p(-1));
    EXPECT_EQ(kInfinity, elementary::log1p(kInfinity));
}

TEST(Elementary, WhatIsNoNumberStaysNone) {
    for (const double x : {elementary::exp(kNan), elementary::expm1(kNan), elementary::log(kNan),
                           elementary::log1p(kNan), elementary::log(-1),
                           elementary::log1p(std::nextafter(-1, -2))}) {
        EXPECT_TRUE(std::isnan(x));
    }
}

TEST(Elementary, ExpRisesFromEachDoubleToTheNext) {
    double x = -1;
    for (int i = 0; i < kSamples; ++i) {
        const double next = std::nextafter(x, 2);
        EXPECT_LE(elementary::exp(x), elementary::exp(next));
        x = next + 1e-4;
    }
}

}  // namespace
}  // namespace poolhall
