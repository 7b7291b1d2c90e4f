#pragma once

#include "shared/math/vec3.hpp"

#include <compare>
#include <cstdint>

namespace poolhall {

/// A ball's place in Scene::balls.
struct BallIndex {
    std::uint16_t value = 0;

    friend constexpr auto operator<=>(const BallIndex&, const BallIndex&) = default;
};

/// What all the balls of a scene share.
struct BallSpec {
    Real radius = 0.028575;  ///< m
    Real mass = 0.170097;    ///< kg

    friend constexpr bool operator==(const BallSpec&, const BallSpec&) = default;
};

/// Values enter the state hash: new ones go to the end.
enum class Motion : std::uint8_t {
    kStationary,
    kRolling,
    kPocketed,
    kSliding,
    kSpinning,  ///< at rest but for spin about the vertical axis, which decays
    kAirborne,
    kOffTable,  ///< has left the table over a rail
};

/// Where a ball is and how it moves.
struct BallState {
    Vec3 r;  ///< centre, m; z is the height above its height at rest on the cloth
    Vec3 v;  ///< m/s
    Vec3 w;  ///< angular velocity, rad/s, right-handed

    friend constexpr bool operator==(const BallState&, const BallState&) = default;
};

}  // namespace poolhall
