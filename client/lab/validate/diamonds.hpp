#pragma once

#include "shared/physics/contact/rail_spec.hpp"

#include <optional>

// Shots off the rails of a 9-ft table by its diamonds, as players count them.
namespace poolhall::lab {

/// A line of the corner-5 system: through the origin's diamond, towards that of the first rail. The
/// corner is 5; from it the origin's numbers fall by a half a diamond along the long rail and rise
/// by one along the short rail. The first rail is the other long rail, numbered from the far end,
/// one a diamond.
struct DiamondLine {
    double origin = 0;
    double first = 0;
};

/// Where the ball comes to its third rail, the long one that it began at: diamonds from the far
/// end. A firm rolling ball with that running side (spin about the vertical in units of v / R).
/// Nothing if it does not go first rail, far short rail, third rail.
[[nodiscard]] std::optional<double> third_rail(const RailSpec& rail, const DiamondLine& line,
                                               double side);

/// The running side by which the line comes to `third`; nothing if none does.
[[nodiscard]] std::optional<double> side_for(const RailSpec& rail, const DiamondLine& line,
                                             double third);

/// The speed (m/s) of a centre hit from the head spot through the foot spot that goes so many
/// lengths of the table.
[[nodiscard]] double speed_for_lengths(const RailSpec& rail, double lengths);

/// A slow rolling ball without side goes to a rail and back to where it is as far from it: how far
/// (m) behind the nose the mirror would be that sends it there. `incidence`: from the normal, rad.
[[nodiscard]] double mirror_depth(const RailSpec& rail, double incidence);

}  // namespace poolhall::lab
