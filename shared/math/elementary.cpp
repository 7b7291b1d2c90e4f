#include "shared/math/elementary.hpp"

#include "shared/math/double_double.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace poolhall::elementary {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// ln 2 = high + low; high has 42 bits, so that its product with an exponent is exact.
constexpr double kLn2High = 0x1.62e42fefa3800p-1;
constexpr double kLn2Low = 0x1.ef35793c76730p-45;
constexpr double kOneOverLn2 = 0x1.71547652b82fep+0;

/// The nearest integer, by rounding at the last bit; |x| < 2^51.
constexpr double nearest_integer(double x) {
    constexpr double kShift = 0x1.8p52;
    return (x + kShift) - kShift;
}

/// 2^k, -1022 <= k <= 1023.
constexpr double power_of_two(int k) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(k + 1023) << 52U);
}

/// x 2^k, |k| <= 2044. In two steps, of which only the second can round or overflow.
constexpr double scaled(double x, int k) {
    const int half = k / 2;
    return x * power_of_two(half) * power_of_two(k - half);
}

/// c[0] + x (c[1] + x (...)).
template <std::size_t N>
constexpr double polynomial(const std::array<double, N>& c, double x) {
    double sum = 0;
    for (std::size_t i = N; i-- > 0;)
        sum = c[i] + x * sum;
    return sum;
}

/// 1/n! from n = 3: what is left out is below 2^-63 for |x| <= ln 2 / 2.
constexpr auto kInverseFactorials = [] {
    std::array<double, 12> c{};
    double factorial = 2;
    for (std::size_t i = 0; i < c.size(); ++i) {
        factorial *= static_cast<double>(i + 3);
        c[i] = 1 / factorial;
    }
    return c;
}();

/// 1/(2n + 1) from n = 1: what is left out is below 2^-65 for x <= (sqrt 2 - 1)^4.
constexpr auto kInverseOddNumbers = [] {
    std::array<double, 12> c{};
    for (std::size_t i = 0; i < c.size(); ++i)
        c[i] = 1 / static_cast<double>(2 * i + 3);
    return c;
}();

/// e^x = 2^exponent (1 + rest), with |rest| <= 0.42.
struct Exponential {
    int exponent;
    DoubleDouble rest;
};

/// |x| <= 746. Cody and Waite's reduction by a multiple of ln 2 in two parts, then Taylor's series.
Exponential exponential(double x) {
    const double k = nearest_integer(x * kOneOverLn2);
    const DoubleDouble r = two_sum(x - k * kLn2High, -k * kLn2Low);
    const DoubleDouble half_square = two_product(r.hi, 0.5 * r.hi);
    const double cube = r.hi * (r.hi * r.hi);
    const double tail = cube * polynomial(kInverseFactorials, r.hi) + r.lo * (1 + r.hi);
    const DoubleDouble sum = quick_two_sum(r.hi, half_square.hi);
    return {static_cast<int>(k), quick_two_sum(sum.hi, sum.lo + (half_square.lo + tail))};
}

/// Logarithm of a positive double-double in the range of normal doubles: log a = k ln 2 + log m
/// with m in [sqrt 1/2, sqrt 2], and log m = 2 artanh((m - 1) / (m + 1)).
double logarithm(DoubleDouble a) {
    constexpr double kSqrtHalf = 0x1.6a09e667f3bcdp-1;
    const auto bits = std::bit_cast<std::uint64_t>(a.hi / kSqrtHalf);
    const int k = static_cast<int>(bits >> 52U) - 1023;
    const DoubleDouble m{scaled(a.hi, -k), scaled(a.lo, -k)};
    const DoubleDouble s = (m - DoubleDouble{1}) / (m + DoubleDouble{1});
    const double square = s.hi * s.hi;
    const double tail = 2 * s.hi * square * polynomial(kInverseOddNumbers, square);
    const DoubleDouble sum = two_sum(k * kLn2High, 2 * s.hi);
    return sum.hi + (sum.lo + (2 * s.lo + (tail + k * kLn2Low)));
}

}  // namespace

double exp(double x) {
    if (x != x) return x;
    if (x > 710) return kInfinity;
    if (x < -746) return 0;
    const Exponential e = exponential(x);
    const DoubleDouble sum = quick_two_sum(1, e.rest.hi);
    return scaled(sum.hi + (sum.lo + e.rest.lo), e.exponent);
}

double expm1(double x) {
    if (x != x) return x;
    if (x > 710) return kInfinity;
    if (x < -50) return -1;
    const Exponential e = exponential(x);
    if (e.exponent == 0) return e.rest.hi + e.rest.lo;
    // 2^k (1 + rest - 2^-k), so that nothing overflows.
    const DoubleDouble sum = two_sum(1, -scaled(1, -e.exponent)) + e.rest;
    return scaled(value(sum), e.exponent);
}

double log(double x) {
    if (x != x || x == kInfinity) return x;
    if (x < 0) return kNan;
    if (x == 0) return -kInfinity;
    constexpr double kLeastNormal = std::numeric_limits<double>::min();
    if (x < kLeastNormal) return logarithm({x * 0x1p54, 0}) - 54 * (kLn2High + kLn2Low);
    return logarithm({x, 0});
}

double log1p(double x) {
    if (x != x || x == kInfinity) return x;
    if (x < -1) return kNan;
    if (x == -1) return -kInfinity;
    if (std::abs(x) < 0x1p-54) return x;  // its half may be nothing
    return logarithm(two_sum(1, x));
}

}  // namespace poolhall::elementary
