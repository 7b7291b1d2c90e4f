#pragma once

#include "shared/math/vec2.hpp"

#include <algorithm>

namespace poolhall {

/// A vector in space: metres, metres a second, or radians a second (right-handed) for angular
/// velocity.
struct Vec3 {
    Real x = 0;
    Real y = 0;
    Real z = 0;

    friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
};

constexpr Vec3 operator+(Vec3 a, Vec3 b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

constexpr Vec3 operator-(Vec3 a, Vec3 b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

constexpr Vec3 operator-(Vec3 a) {
    return {-a.x, -a.y, -a.z};
}

constexpr Vec3 operator*(Real s, Vec3 a) {
    return {s * a.x, s * a.y, s * a.z};
}

constexpr Real dot(Vec3 a, Vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Right-handed: x cross y is z.
constexpr Vec3 cross(Vec3 a, Vec3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline Real norm(Vec3 a) {
    return sqrt(dot(a, a));
}

/// a / |a|. Scales first, as in the plane; a zero vector stays zero.
inline Vec3 normalized(Vec3 a) {
    const Real largest = std::max({abs(a.x), abs(a.y), abs(a.z)});
    if (largest == 0) return {};
    const Vec3 scaled{a.x / largest, a.y / largest, a.z / largest};
    const Real length = norm(scaled);
    return {scaled.x / length, scaled.y / length, scaled.z / length};
}

/// The part in the plane of the cloth.
constexpr Vec2 xy(const Vec3& a) {
    return {a.x, a.y};
}

constexpr void set_xy(Vec3& a, Vec2 value) {
    a.x = value.x;
    a.y = value.y;
}

}  // namespace poolhall
