#pragma once

#include "shared/math/vec2.hpp"

namespace poolhall {

/// A vector in space: metres, metres a second, or radians a second (right-handed) for angular
/// velocity.
struct Vec3 {
    double x = 0;
    double y = 0;
    double z = 0;

    friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
};

/// The part in the plane of the cloth.
constexpr Vec2 xy(const Vec3& a) {
    return {a.x, a.y};
}

constexpr void set_xy(Vec3& a, Vec2 value) {
    a.x = value.x;
    a.y = value.y;
}

}  // namespace poolhall
