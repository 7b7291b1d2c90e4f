#include "shared/math/double_double.hpp"

#include "tests/shared/quad.hpp"
#include "tests/shared/random.hpp"

#include <gtest/gtest.h>

namespace poolhall {
namespace {

using testing::Quad;

/// Rounding that double-double arithmetic may leave: a few units of 2^-104. The reference has
/// 2^-113.
constexpr double kTolerance = 0x1p-101;

Quad exact(DoubleDouble a) {
    return Quad{a.hi} + a.lo;
}

DoubleDouble random_number(testing::Random& random) {
    const double hi = random.uniform(-2, 2);
    return quick_two_sum(hi, hi * random.uniform(-1, 1) * 0x1p-54);
}

void expect_close(Quad expected, DoubleDouble actual, Quad scale) {
    EXPECT_LE(testing::to_double(testing::abs((exact(actual) - expected) / scale)), kTolerance);
    EXPECT_EQ(actual.hi, actual.hi + actual.lo) << "not normalised";
}

TEST(DoubleDouble, SumsAndProductsOfDoublesAreExact) {
    testing::Random random(1);
    for (int i = 0; i < 10000; ++i) {
        const double a = random.uniform(-1, 1);
        const double b = random.uniform(-1, 1);
        EXPECT_TRUE(exact(two_sum(a, b * 0x1p-30)) == Quad{a} + Quad{b * 0x1p-30});
        EXPECT_TRUE(exact(two_product(a, b)) == Quad{a} * Quad{b});
    }
}

TEST(DoubleDouble, ArithmeticAgreesWith113Bits) {
    testing::Random random(2);
    for (int i = 0; i < 10000; ++i) {
        const DoubleDouble a = random_number(random);
        const DoubleDouble b = random_number(random);
        const Quad size = testing::abs(exact(a)) + testing::abs(exact(b));
        expect_close(exact(a) + exact(b), a + b, size);
        expect_close(exact(a) - exact(b), a - b, size);
        expect_close(exact(a) * exact(b), a * b, exact(a) * exact(b));
        expect_close(exact(a) / exact(b), a / b, exact(a) / exact(b));
        const DoubleDouble square = a * a;
        expect_close(testing::abs(exact(a)), sqrt(square), exact(a));
    }
}

TEST(DoubleDouble, DifferencesOfCloseNumbersKeepTheirDigits) {
    const DoubleDouble third = DoubleDouble{1} / DoubleDouble{3};
    const DoubleDouble rest = third - DoubleDouble{third.hi};
    EXPECT_EQ(third.lo, rest.hi);
    EXPECT_NEAR(0, value(third + third + third - DoubleDouble{1}), kTolerance);
}

TEST(DoubleDouble, TheRootOfNothingAndOfLessIsNothing) {
    EXPECT_EQ(0, value(sqrt(DoubleDouble{0})));
    EXPECT_EQ(0, value(sqrt(DoubleDouble{-1e-30})));
}

TEST(DoubleDouble, CrossProductOfNearlyParallelVectorsIsExact) {
    // 1 + 2^-52 and 1 - 2^-53: in doubles the products round to the same number.
    const Vec2DoubleDouble a = exact_difference({1 + 0x1p-52, 1}, {});
    const Vec2DoubleDouble b = exact_difference({1, 1 - 0x1p-53}, {});
    EXPECT_EQ(0x1p-53 - 0x1p-105, value(cross(a, b)));
}

}  // namespace
}  // namespace poolhall
