#pragma once

#include <cmath>

namespace poolhall {

/// A vector in the plane of the cloth; metres or metres a second.
struct Vec2 {
    double x = 0;
    double y = 0;

    friend constexpr bool operator==(const Vec2&, const Vec2&) = default;
};

constexpr Vec2 operator+(Vec2 a, Vec2 b) {
    return {a.x + b.x, a.y + b.y};
}

constexpr Vec2 operator-(Vec2 a, Vec2 b) {
    return {a.x - b.x, a.y - b.y};
}

constexpr Vec2 operator-(Vec2 a) {
    return {-a.x, -a.y};
}

constexpr Vec2 operator*(double s, Vec2 a) {
    return {s * a.x, s * a.y};
}

constexpr double dot(Vec2 a, Vec2 b) {
    return a.x * b.x + a.y * b.y;
}

/// z component of a x b; positive when b is to the left of a.
constexpr double cross(Vec2 a, Vec2 b) {
    return a.x * b.y - a.y * b.x;
}

inline double norm(Vec2 a) {
    return std::sqrt(dot(a, a));
}

/// a / |a|. Scales first, so that neither 1e200 nor 5e-324 is lost; a zero vector stays zero.
inline Vec2 normalized(Vec2 a) {
    const double ax = a.x < 0 ? -a.x : a.x;
    const double ay = a.y < 0 ? -a.y : a.y;
    const double largest = ax > ay ? ax : ay;
    if (largest == 0) return {};
    // Two divisions rather than one by a reciprocal: 1 / 5e-324 is infinite.
    const Vec2 scaled{a.x / largest, a.y / largest};
    const double length = norm(scaled);
    return {scaled.x / length, scaled.y / length};
}

/// |a| of any vector: norm() loses what is below 1e-154 or above 1e154.
inline double length(Vec2 a) {
    const double square = dot(a, a);
    // Normal numbers with all their digits.
    if (square >= 0x1p-960 && square <= 0x1p1020) [[likely]]
        return std::sqrt(square);
    return a == Vec2{} ? 0 : dot(normalized(a), a);
}

}  // namespace poolhall
