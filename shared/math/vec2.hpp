#pragma once

#include "shared/math/real.hpp"

namespace poolhall {

/// A vector in the plane of the cloth; metres or metres a second.
struct Vec2 {
    Real x = 0;
    Real y = 0;

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

constexpr Vec2 operator*(Real s, Vec2 a) {
    return {s * a.x, s * a.y};
}

constexpr Real dot(Vec2 a, Vec2 b) {
    return a.x * b.x + a.y * b.y;
}

/// z component of a x b; positive when b is to the left of a.
constexpr Real cross(Vec2 a, Vec2 b) {
    return a.x * b.y - a.y * b.x;
}

inline Real norm(Vec2 a) {
    return sqrt(dot(a, a));
}

/// a / |a|. Scales first, so that neither 1e200 nor 5e-324 is lost; a zero vector stays zero.
inline Vec2 normalized(Vec2 a) {
    const Real ax = a.x < 0 ? -a.x : a.x;
    const Real ay = a.y < 0 ? -a.y : a.y;
    const Real largest = ax > ay ? ax : ay;
    if (largest == 0) return {};
    // Two divisions rather than one by a reciprocal: 1 / 5e-324 is infinite.
    const Vec2 scaled{a.x / largest, a.y / largest};
    const Real length = norm(scaled);
    return {scaled.x / length, scaled.y / length};
}

/// |a| of any vector: norm() loses what is below 1e-154 or above 1e154.
inline Real length(Vec2 a) {
    const Real square = dot(a, a);
    // Normal numbers with all their digits.
    if (square >= 0x1p-960 && square <= 0x1p1020) [[likely]]
        return sqrt(square);
    return a == Vec2{} ? 0 : dot(normalized(a), a);
}

}  // namespace poolhall
