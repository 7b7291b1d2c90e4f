#include "shared/physics/contact/time_of_impact.hpp"

#include "shared/math/double_double.hpp"

#include <algorithm>

namespace poolhall {

namespace {

/// Velocities outside these are scaled by a power of two, so that no product over- or underflows.
constexpr Real kHugeSpeed = 0x1p300;
constexpr Real kTinySpeed = 0x1p-300;
constexpr Real kScale = 0x1p600;

/// Below this share of c.c, C = c.c - d^2 has lost too many digits.
constexpr Real kNear = 0x1p-3;
/// Bound of the relative rounding error of q, generously: four operations each side.
constexpr Real kRounding = 4 * kEpsilon;
/// |q| within this share of its terms is an exact graze: what double-double leaves of zero. One ulp
/// of offset is kEpsilon.
constexpr Real kExactGraze = 64 * kEpsilon * kEpsilon;
/// Relative error that the fast path may leave in t.
constexpr Real kAllowed = 4 * kEpsilon;

Real abs_max(Vec2 a) {
    return std::max(abs(a.x), abs(a.y));
}

/// The terms of the quadratic A t^2 - 2 B t + C = 0 in double-double, from unrounded differences.
struct PreciseTerms {
    PreciseTerms(const UniformMotion& a, const UniformMotion& b, Real distance)
        : c(exact_difference(b.r, a.r)), v(exact_difference(b.v, a.v)) {
        const DoubleDouble distance_squared = two_product(distance, distance);
        gap = dot(c, c) - distance_squared;
        approach = -dot(c, v);
        const DoubleDouble left = c.x * v.y;
        const DoubleDouble right = c.y * v.x;
        const DoubleDouble area = left - right;
        const DoubleDouble reach = dot(v, v) * distance_squared;
        q = reach - area * area;
        q_error = kExactGraze * (reach.hi + abs(area.hi) * (abs(left.hi) + abs(right.hi)));
    }

    Vec2DoubleDouble c;
    Vec2DoubleDouble v;
    DoubleDouble gap;       ///< C
    DoubleDouble approach;  ///< B
    DoubleDouble q;
    Real q_error;  ///< bound of the rounding error of q
};

std::optional<Real> precise_time(const UniformMotion& a, const UniformMotion& b, Real distance) {
    const PreciseTerms terms(a, b, distance);
    if (terms.approach.hi <= 0) return std::nullopt;
    if (terms.gap.hi <= 0) return 0;
    if (terms.q.hi < -terms.q_error) return std::nullopt;
    return value(terms.gap) / value(terms.approach + sqrt(terms.q));
}

/// The scaled problem: no intermediate result over- or underflows.
std::optional<Real> scaled_time(const UniformMotion& a, const UniformMotion& b, Real distance) {
    const Vec2 c = b.r - a.r;
    const Vec2 v = b.v - a.v;
    const Real approach = -dot(c, v);
    const Real square = dot(c, c);
    const Real gap = square - distance * distance;
    const Real left = c.x * v.y;
    const Real right = c.y * v.x;
    const Real area = left - right;
    const Real reach = dot(v, v) * distance * distance;
    const Real q = reach - area * area;
    const Real q_error = kRounding * (abs(area) * (abs(left) + abs(right)) + reach);
    if (gap > kNear * square) {
        if (approach <= 0 || q < -q_error) return std::nullopt;
        if (q > q_error) {
            const Real root = sqrt(q);
            const Real denominator = approach + root;
            if (q_error <= kAllowed * root * denominator) return gap / denominator;
        }
    }
    // Balls that touch mostly part; what is beyond rounding needs no more digits.
    if (approach < -kRounding * (abs(c.x * v.x) + abs(c.y * v.y))) return std::nullopt;
    return precise_time(a, b, distance);
}

/// The power of two that brings the speeds to where no product over- or underflows.
Real speed_scale(Vec2 v_a, Vec2 v_b) {
    const Real speed = std::max(abs_max(v_a), abs_max(v_b));
    if (speed > kHugeSpeed) return 1 / kScale;
    return speed < kTinySpeed ? kScale : 1;
}

}  // namespace

std::optional<Real> time_of_impact(const UniformMotion& a, const UniformMotion& b, Real distance) {
    const Real scale = speed_scale(a.v, b.v);
    if (scale == 1) return scaled_time(a, b, distance);
    const std::optional<Real> t = scaled_time({a.r, scale * a.v}, {b.r, scale * b.v}, distance);
    if (!t) return std::nullopt;
    return *t * scale;
}

Real time_since_impact(const UniformMotion& a, const UniformMotion& b, Real distance) {
    const Real scale = speed_scale(a.v, b.v);
    const PreciseTerms terms({a.r, scale * a.v}, {b.r, scale * b.v}, distance);
    const DoubleDouble root = sqrt(terms.q);
    // Of the two ways to write the root of the quadratic, the one that adds.
    if (terms.approach.hi > 0) return -value(terms.gap) / value(terms.approach + root) * scale;
    return value(root - terms.approach) / value(dot(terms.v, terms.v)) * scale;
}

}  // namespace poolhall
