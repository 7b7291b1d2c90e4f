#pragma once

#include "shared/table/table.hpp"

#include <array>
#include <span>

namespace poolhall {

/// The shape of a pocket's mouth. The same numbers on every table: a mouth is cut for the balls,
/// not for the table. Sources in shared/PHYSICS.md, "The pool table".
struct MouthSpec {
    Real width;        ///< between the points where nose and facing would meet unrounded, m
    Vec2 facing;       ///< unit vector along a facing: {back towards the pocket, out of the table}
    Real jaw_radius;   ///< of the nose where it turns into the mouth, m
    Real shelf;        ///< from the middle of the mouth's line to the edge where balls drop, m
    Real hole_radius;  ///< of that edge, m
};

/// WPA: mouth 4 1/2 to 4 5/8 in, cut 142 degrees, shelf 1 to 2 1/4 in. The facing turns 142 - 90
/// degrees away from straight out: {sin 52, cos 52}.
inline constexpr MouthSpec kCornerMouth{
    .width = 0.1158875,  // 4 9/16 in
    .facing = {0.78801075360672196, 0.61566147532565828},
    .jaw_radius = 0.02095,
    .shelf = 0.041275,  // 1 5/8 in
    .hole_radius = 0.062,
};

/// WPA: mouth 5 to 5 1/8 in, cut 104 degrees, shelf 0 to 3/8 in. {sin 14, cos 14}.
inline constexpr MouthSpec kSideMouth{
    .width = 0.1285875,  // 5 1/16 in
    .facing = {0.24192189559966772, 0.97029572627599647},
    .jaw_radius = 0.00795,
    .shelf = 0.0047625,  // 3/16 in
    .hole_radius = 0.0645,
};

/// From the nose of a cushion to its back, where the facings end; m. WPA: 1 7/8 to 2 in.
inline constexpr Real kCushionWidth = 0.0508;

/// A straight stretch of rubber; balls touch it from the side that `normal` points away from.
struct CushionLine {
    Vec2 from;    ///< m
    Vec2 to;      ///< m
    Vec2 normal;  ///< unit, from the table into the rubber
    Rail rail = Rail::kNorth;
};

/// A rounded rail end: a convex arc of the nose, tangent to the lines on both sides of it.
struct CushionArc {
    Vec2 centre;      ///< m
    Real radius = 0;  ///< m
    Vec2 from;        ///< unit, from the centre to the joint with the rail's long line
    Vec2 to;          ///< unit, from the centre to the joint with the facing; under 90 degrees away
    Rail rail = Rail::kNorth;
};

/// A hole captures a ball whose centre comes within `radius` of `centre`.
struct Hole {
    Vec2 centre;      ///< m
    Real radius = 0;  ///< m
    Pocket pocket = Pocket::kNorthWest;
};

/// Whether the foot of the perpendicular from `point` (m) lies on the line, both ends included.
[[nodiscard]] constexpr bool within(const CushionLine& line, Vec2 point) {
    const Vec2 along = line.to - line.from;
    return dot(point - line.from, along) >= 0 && dot(line.to - point, along) >= 0;
}

/// How far, in radians, an arc reaches beyond its joints. A ball that arrives at a joint is told
/// from the line by one instant and from the arc by another, a rounding error apart, and must not
/// slip between the two. The surplus lies below the line's surface by 1e-18 of the radius, so no
/// ball meets it first.
inline constexpr Real kJointSlack = 1e-9;

/// Whether `direction` (any length but zero), seen from the arc's centre, lies in its sector.
[[nodiscard]] constexpr bool within(const CushionArc& arc, Vec2 direction) {
    // Crosses times the sense of rotation: the same bits for an arc and its mirror image.
    const Real turn = cross(arc.from, arc.to);
    return cross(arc.from, direction) * turn >= -kJointSlack * dot(arc.from, direction) &&
           cross(direction, arc.to) * turn >= -kJointSlack * dot(arc.to, direction);
}

/// The rubber and the holes of a full table: six rails between six mouths, each rail end rounded
/// and then running back along a facing. Bit-exactly symmetric under x -> -x and y -> -y.
class PoolTable {
  public:
    /// Requires is_large_enough_for_pool(table), and balls that pass fits_pool_table().
    explicit PoolTable(const Table& table);

    /// The six rails in the order N west half, N east half, E, S east half, S west half, W, then
    /// the facings in the order of their names in Rail.
    [[nodiscard]] std::span<const CushionLine> lines() const { return lines_; }

    /// The rail ends in the order of their names in Rail.
    [[nodiscard]] std::span<const CushionArc> arcs() const { return arcs_; }

    /// In the order of Pocket.
    [[nodiscard]] std::span<const Hole> holes() const { return holes_; }

  private:
    std::array<CushionLine, 6 + 12> lines_;
    std::array<CushionArc, 12> arcs_;
    std::array<Hole, kPocketCount> holes_;
};

/// Whether the rails are longer than what their mouths take: 0.319 m by 0.179 m.
[[nodiscard]] bool is_large_enough_for_pool(const Table& table);

/// Whether a ball of this radius (m) gets through every mouth: up to 52.48 mm. Of such balls none
/// gets out of the table but into a hole.
[[nodiscard]] bool fits_pool_table(Real ball_radius);

}  // namespace poolhall
