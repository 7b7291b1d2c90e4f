#pragma once

#include "shared/fields.hpp"
#include "shared/math/vec2.hpp"
#include "shared/table/bounds.hpp"

#include <tuple>

namespace poolhall {

/// The shape of a pocket's mouth. Sources in shared/PHYSICS.md, "The pool table".
struct MouthSpec {
    Real width = 0;  ///< between the points where nose and facing would meet unrounded, m
    /// Along a facing, {back towards the pocket, out of the table}; of any length but zero. It runs
    /// out and not away from the pocket.
    Vec2 facing;
    Real jaw_radius = 0;   ///< of the nose where it turns into the mouth, m
    Real shelf = 0;        ///< from the middle of the mouth's line to the edge where balls drop, m
    Real hole_radius = 0;  ///< of that edge, m

    static constexpr auto field_list() {
        constexpr fields::Bounds kSize = fields::positive(kMaxLength);
        return std::tuple{
            fields::of("width", &MouthSpec::width, kSize).in("m").or_default(),
            fields::of("facing", &MouthSpec::facing, kPlaces).or_default(),
            fields::of("jaw_radius", &MouthSpec::jaw_radius, kSize).in("m").or_default(),
            fields::of("shelf", &MouthSpec::shelf, {0, kMaxLength}).in("m").or_default(),
            fields::of("hole_radius", &MouthSpec::hole_radius, kSize).in("m").or_default()};
    }

    friend constexpr bool operator==(const MouthSpec&, const MouthSpec&) = default;
};

/// WPA: mouth 4 1/2 to 4 5/8 in, cut 142 degrees, shelf 1 to 2 1/4 in. The facing turns 142 - 90
/// degrees away from straight out: {sin 52, cos 52}. No specification has the radius of a jaw's
/// point; real ones are sharp, a few millimetres.
inline constexpr MouthSpec kCornerMouth{
    .width = 0.1158875,  // 4 9/16 in
    .facing = {0.78801075360672196, 0.61566147532565828},
    .jaw_radius = 0.004,
    .shelf = 0.041275,  // 1 5/8 in
    .hole_radius = 0.062,
};

/// WPA: mouth 5 to 5 1/8 in, cut 104 degrees, shelf 0 to 3/8 in. {sin 14, cos 14}.
inline constexpr MouthSpec kSideMouth{
    .width = 0.1285875,  // 5 1/16 in
    .facing = {0.24192189559966772, 0.97029572627599647},
    .jaw_radius = 0.004,
    .shelf = 0.0047625,  // 3/16 in
    .hole_radius = 0.0645,
};

/// From the nose of a cushion to its back, where the facings end; m. WPA: 1 7/8 to 2 in.
inline constexpr Real kCushionWidth = 0.0508;

/// The mouths of a table: all four corners alike, and both sides.
struct Mouths {
    MouthSpec corner = kCornerMouth;
    MouthSpec side = kSideMouth;

    static constexpr auto field_list() {
        return std::tuple{fields::of("corner", &Mouths::corner).or_default(),
                          fields::of("side", &Mouths::side).or_default()};
    }

    friend constexpr bool operator==(const Mouths&, const Mouths&) = default;
};

}  // namespace poolhall
