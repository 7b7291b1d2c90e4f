#pragma once

#include "shared/enum_names.hpp"
#include "shared/fields.hpp"
#include "shared/math/vec3.hpp"
#include "shared/table/bounds.hpp"

#include <compare>
#include <cstdint>
#include <tuple>

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

    static constexpr auto field_list() {
        return std::tuple{
            fields::of("radius", &BallSpec::radius, fields::positive(kMaxLength)).in("m"),
            fields::of("mass", &BallSpec::mass, fields::positive(kMaxLength)).in("kg")};
    }

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

constexpr auto enum_names(Motion /*type*/) {
    return names_of<Motion>({{Motion::kStationary, "stationary"},
                             {Motion::kRolling, "rolling"},
                             {Motion::kPocketed, "pocketed"},
                             {Motion::kSliding, "sliding"},
                             {Motion::kSpinning, "spinning"},
                             {Motion::kAirborne, "airborne"},
                             {Motion::kOffTable, "off_table"}});
}

/// Where a ball is and how it moves.
struct BallState {
    Vec3 r;  ///< centre, m; z is the height above its height at rest on the cloth
    Vec3 v;  ///< m/s
    Vec3 w;  ///< angular velocity, rad/s, right-handed

    static constexpr auto field_list() {
        return std::tuple{fields::of("r", &BallState::r).in("m"),
                          fields::of("v", &BallState::v).in("m/s"),
                          fields::of("w", &BallState::w).in("rad/s")};
    }

    friend constexpr bool operator==(const BallState&, const BallState&) = default;
};

}  // namespace poolhall
