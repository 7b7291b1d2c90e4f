#pragma once

#include "shared/math/vec3.hpp"

namespace poolhall {

/// An unevaluated sum hi + lo with |lo| <= ulp(hi)/2: twice the bits of Real, 106 of doubles,
/// from + - * and sqrt only. Dekker, "A floating-point technique for extending the available
/// precision", 1971; Knuth's two-sum. Exact as long as nothing over- or underflows: callers scale
/// first.
struct DoubleDouble {
    Real hi = 0;
    Real lo = 0;
};

/// a + b exactly.
constexpr DoubleDouble two_sum(Real a, Real b) {
    const Real sum = a + b;
    const Real b_part = sum - a;
    return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// a + b exactly, for |a| >= |b|.
constexpr DoubleDouble quick_two_sum(Real a, Real b) {
    const Real sum = a + b;
    return {sum, b - (sum - a)};
}

/// a * b exactly. Dekker's split, not fma: fma is a library call on plain x86-64.
constexpr DoubleDouble two_product(Real a, Real b) {
    constexpr Real kSplit = power_of_two((kRealDigits + 1) / 2) + 1;
    const Real a_big = kSplit * a;
    const Real a_hi = a_big - (a_big - a);
    const Real a_lo = a - a_hi;
    const Real b_big = kSplit * b;
    const Real b_hi = b_big - (b_big - b);
    const Real b_lo = b - b_hi;
    const Real product = a * b;
    return {product, ((a_hi * b_hi - product) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo};
}

constexpr DoubleDouble operator-(DoubleDouble a) {
    return {-a.hi, -a.lo};
}

constexpr DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble high = two_sum(a.hi, b.hi);
    const DoubleDouble low = two_sum(a.lo, b.lo);
    const DoubleDouble sum = quick_two_sum(high.hi, high.lo + low.hi);
    return quick_two_sum(sum.hi, sum.lo + low.lo);
}

constexpr DoubleDouble operator-(DoubleDouble a, DoubleDouble b) {
    return a + -b;
}

constexpr DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble product = two_product(a.hi, b.hi);
    return quick_two_sum(product.hi, product.lo + (a.hi * b.lo + a.lo * b.hi));
}

/// Long division, three digits of the size of Real.
constexpr DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
    const Real first = a.hi / b.hi;
    const DoubleDouble rest = a - b * DoubleDouble{first};
    const Real second = rest.hi / b.hi;
    const Real third = (rest - b * DoubleDouble{second}).hi / b.hi;
    return quick_two_sum(first, second) + DoubleDouble{third};
}

/// Square root of a number that is not negative: one Newton step on the double's root.
inline DoubleDouble sqrt(DoubleDouble a) {
    if (a.hi <= 0) return {};
    const Real root = sqrt(a.hi);
    const DoubleDouble rest = a - two_product(root, root);
    return quick_two_sum(root, rest.hi / (2 * root));
}

constexpr Real value(DoubleDouble a) {
    return a.hi + a.lo;
}

struct Vec2DoubleDouble {
    DoubleDouble x;
    DoubleDouble y;
};

struct Vec3DoubleDouble {
    DoubleDouble x;
    DoubleDouble y;
    DoubleDouble z;
};

constexpr Vec3 value(const Vec3DoubleDouble& a) {
    return {value(a.x), value(a.y), value(a.z)};
}

/// a - b without rounding.
constexpr Vec2DoubleDouble exact_difference(Vec2 a, Vec2 b) {
    return {two_sum(a.x, -b.x), two_sum(a.y, -b.y)};
}

constexpr DoubleDouble dot(const Vec2DoubleDouble& a, const Vec2DoubleDouble& b) {
    return a.x * b.x + a.y * b.y;
}

constexpr DoubleDouble cross(const Vec2DoubleDouble& a, const Vec2DoubleDouble& b) {
    return a.x * b.y - a.y * b.x;
}

}  // namespace poolhall
