#include "shared/physics/time_of_impact.hpp"

#include "shared/math/double_double.hpp"

#include <cmath>
#include <limits>

namespace poolhall {

namespace {

/// Velocities outside these are scaled by a power of two, so that no product over- or underflows.
constexpr double kHugeSpeed = 0x1p300;
constexpr double kTinySpeed = 0x1p-300;
constexpr double kScale = 0x1p600;

/// Below this share of c.c, C = c.c - d^2 has lost too many digits.
constexpr double kNear = 0x1p-6;
/// Bound of the relative rounding error of q, generously: four operations each side.
constexpr double kRounding = 0x1p-50;
/// |q| within this share of its terms is an exact graze: what double-double leaves of zero. One ulp
/// of offset is 2^-52.
constexpr double kExactGraze = 0x1p-100;
/// Relative error that the fast path may leave in t.
constexpr double kAllowed = 0x1p-50;

double abs_max(Vec2 a) {
    const double x = std::abs(a.x);
    const double y = std::abs(a.y);
    return x > y ? x : y;
}

std::optional<double> precise_time(const Vec2DoubleDouble& c, const Vec2DoubleDouble& v,
                                   double distance) {
    const DoubleDouble b = -dot(c, v);
    if (b.hi <= 0) return std::nullopt;
    const DoubleDouble distance_squared = two_product(distance, distance);
    const DoubleDouble gap = dot(c, c) - distance_squared;
    if (gap.hi <= 0) return 0;
    const DoubleDouble area = cross(c, v);
    const DoubleDouble reach = dot(v, v) * distance_squared;
    const DoubleDouble q = reach - area * area;
    if (q.hi < -kExactGraze * reach.hi) return std::nullopt;
    return value(gap) / value(b + sqrt(q));
}

/// The scaled problem: no intermediate result over- or underflows.
std::optional<double> scaled_time(const UniformMotion& a, const UniformMotion& b, double distance) {
    const Vec2 c = b.r - a.r;
    const Vec2 v = b.v - a.v;
    const double approach = -dot(c, v);
    const double square = dot(c, c);
    const double gap = square - distance * distance;
    const double left = c.x * v.y;
    const double right = c.y * v.x;
    const double area = left - right;
    const double reach = dot(v, v) * distance * distance;
    const double q = reach - area * area;
    const double q_error =
        kRounding * (std::abs(area) * (std::abs(left) + std::abs(right)) + reach);
    if (gap > kNear * square) {
        if (approach <= 0 || q < -q_error) return std::nullopt;
        if (q > q_error) {
            const double root = std::sqrt(q);
            const double denominator = approach + root;
            if (q_error <= kAllowed * root * denominator) return gap / denominator;
        }
    }
    return precise_time(exact_difference(b.r, a.r), exact_difference(b.v, a.v), distance);
}

}  // namespace

std::optional<double> time_of_impact(const UniformMotion& a, const UniformMotion& b,
                                     double distance) {
    const double speed = abs_max(a.v) > abs_max(b.v) ? abs_max(a.v) : abs_max(b.v);
    if (speed == 0) return std::nullopt;
    if (speed <= kHugeSpeed && speed >= kTinySpeed) return scaled_time(a, b, distance);
    const double scale = speed > kHugeSpeed ? 1 / kScale : kScale;
    const std::optional<double> t = scaled_time({a.r, scale * a.v}, {b.r, scale * b.v}, distance);
    if (!t) return std::nullopt;
    return *t * scale;
}

double time_since_impact(const UniformMotion& a, const UniformMotion& b, double distance) {
    const Vec2 c = a.r - b.r;
    const Vec2 v = b.v - a.v;
    const Vec2 along = normalized(v);
    const double aside = cross(along, c);
    // (d - aside)(d + aside) rather than d^2 - aside^2: no cancellation of squares near grazing.
    const double half_chord = std::sqrt((distance - aside) * (distance + aside));
    return (half_chord - dot(along, c)) / norm(v);
}

}  // namespace poolhall
