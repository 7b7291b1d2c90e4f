#pragma once

#include "shared/table/table.hpp"

#include <array>
#include <optional>
#include <span>
#include <string_view>

namespace poolhall {

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
    /// Requires a table that has no fault_of_mouths().
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

/// How far holes come into the table from the lines of the noses, m; 0 if they do not.
[[nodiscard]] Real hole_depth(const Table& table);

/// What is wrong with the shape of the table's mouths, and where: a pointer from the table on.
struct MouthFault {
    std::string_view pointer;  ///< "/mouths/corner"
    std::string_view reason;
};

/// Of a table that has none, no ball that fits_pool_table() gets out but into a hole.
[[nodiscard]] std::optional<MouthFault> fault_of_mouths(const Table& table);

/// Whether a ball of this radius (m) gets through every mouth: with Mouths{}, up to 52.48 mm.
[[nodiscard]] bool fits_pool_table(const Table& table, Real ball_radius);

}  // namespace poolhall
