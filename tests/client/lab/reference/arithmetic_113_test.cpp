// The numbers of the second compilation, of which this is a part: here `poolhall` says
// poolhall_113.

#include "client/lab/corpora/random.hpp"
#include "client/lab/reference/simulation_113.hpp"
#include "shared/math/double_double.hpp"
#include "shared/math/elementary.hpp"
#include "shared/math/vec3.hpp"
#include "shared/physics/contact/time_of_impact.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <gtest/gtest.h>

namespace poolhall {
namespace {

/// 100 decimal digits, by another library than what is tested.
using Exact = boost::multiprecision::cpp_bin_float_100;

Exact exact(Real x) {
    Exact sum = 0;
    for (int i = 0; i < 3; ++i) {  // of 53 bits each
        const auto part = static_cast<double>(x);
        sum += part;
        x -= part;
    }
    return sum;
}

Exact exact(DoubleDouble x) {
    return exact(x.hi) + exact(x.lo);
}

/// Over 2^-40 to 2^40, with all its bits.
Real random_number(lab::Random& random) {
    Real x = 1;
    for (const int bits : {1, 54, 107})  // 53 at a time
        x += power_of_two(-bits) * random.uniform(0, 1);
    return x * power_of_two(static_cast<int>(random.below(81)) - 40);
}

/// |actual / expected - 1| in units of kEpsilon.
double error_of(const Exact& actual, const Exact& expected) {
    return static_cast<double>(abs(actual / expected - 1) / exact(kEpsilon));
}

TEST(Arithmetic113, NumbersHave113Bits) {
    EXPECT_EQ(Exact(2), exact(kEpsilon) * pow(Exact(2), 113));
    EXPECT_NE(Real{1}, 1 + kEpsilon);
    EXPECT_EQ(Real{1}, 1 + kEpsilon / 2);
    EXPECT_EQ(kEpsilon, kRootEpsilon * kRootEpsilon);
}

TEST(Arithmetic113, SquareRootIsRoundedToTheNearest) {
    lab::Random random(1);
    for (int i = 0; i < 2000; ++i) {
        const Real x = random_number(random);
        const Real root = sqrt(x);
        // Half a unit in the last place of a number in [1, 2) is half of kEpsilon.
        EXPECT_LE(error_of(exact(root), sqrt(exact(x))), 0.5 + 1e-15);
    }
    EXPECT_EQ(Real{0}, sqrt(Real{0}));
    EXPECT_EQ(Real{3}, sqrt(Real{9}));
}

TEST(Arithmetic113, SumsAndProductsOfTwoAreExact) {
    lab::Random random(2);
    for (int i = 0; i < 2000; ++i) {
        const Real a = random_number(random);
        const Real b = -random_number(random);
        EXPECT_EQ(exact(a) + exact(b), exact(two_sum(a, b)));
        EXPECT_EQ(exact(a) * exact(b), exact(two_product(a, b)));
    }
}

TEST(Arithmetic113, PairsOfNumbersHaveTwiceTheBits) {
    lab::Random random(3);
    for (int i = 0; i < 500; ++i) {
        const DoubleDouble a = two_product(random_number(random), random_number(random));
        const DoubleDouble b = two_product(random_number(random), random_number(random));
        const double least = 16 * static_cast<double>(kEpsilon);
        EXPECT_LE(error_of(exact(a / b), exact(a) / exact(b)), least);
        EXPECT_LE(error_of(exact(a * b), exact(a) * exact(b)), least);
        EXPECT_LE(error_of(exact(sqrt(a)), sqrt(exact(a))), least);
    }
}

TEST(Arithmetic113, ElementaryFunctionsAreOf113Bits) {
    lab::Random random(4);
    for (int i = 0; i < 500; ++i) {
        const Real x = random.uniform(-20, 20);
        EXPECT_LE(error_of(exact(elementary::exp(x)), exp(exact(x))), 2);
        EXPECT_LE(error_of(exact(elementary::expm1(x / 1024)), expm1(exact(x / 1024))), 2);
        const Real y = random_number(random);
        EXPECT_LE(error_of(exact(elementary::log(y)), log(exact(y))), 2);
        EXPECT_LE(error_of(exact(elementary::log1p(y)), log1p(exact(y))), 2);
    }
}

TEST(Arithmetic113, VectorsAreNormalizedAndMeasured) {
    lab::Random random(5);
    for (int i = 0; i < 500; ++i) {
        const Vec2 a{random_number(random), -random_number(random)};
        const Exact square = exact(a.x) * exact(a.x) + exact(a.y) * exact(a.y);
        EXPECT_LE(error_of(exact(norm(a)), sqrt(square)), 2);
        EXPECT_LE(error_of(exact(length(a)), sqrt(square)), 2);
        const Vec2 unit = normalized(a);
        EXPECT_LE(error_of(exact(unit.x), exact(a.x) / sqrt(square)), 4);
        const Vec3 b = normalized(Vec3{a.x, a.y, random_number(random)});
        EXPECT_LE(error_of(exact(dot(b, b)), 1), 8);
    }
}

TEST(Arithmetic113, GrazesAreToldToTheLastOf113Bits) {
    const Real distance = 2 * Real{0.028575};
    const auto meets = [&](Real offset) {
        return time_of_impact({{0, 0}, {1.7, 0}}, {{Real{1} / 3, offset}, {}}, distance)
            .has_value();
    };
    EXPECT_TRUE(meets(distance));
    EXPECT_TRUE(meets(distance * (1 - kEpsilon)));
    EXPECT_FALSE(meets(distance * (1 + kEpsilon)));
}

}  // namespace
}  // namespace poolhall
