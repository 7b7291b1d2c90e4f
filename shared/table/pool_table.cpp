#include "shared/table/pool_table.hpp"

#include <algorithm>

namespace poolhall {

namespace {

constexpr Real kHalfSqrt2 = 0.70710678118654752;

/// One rail end as seen from the rail: x runs along the nose away from the pocket, from the
/// crossing of a corner's nose lines or from the middle of a long rail; y out of the table. And the
/// hole of its pocket.
struct RailEnd {
    Vec2 arc_centre;  ///< x is also where the straight nose begins
    Vec2 facing_from;
    Vec2 facing_to;
    Vec2 facing_normal;
    Real radius = 0;
    Vec2 hole;
    Vec2 hole_edge;  ///< where balls drop, in the middle of the mouth
    Real hole_radius = 0;
};

/// `mouth_start` is where the mouth begins along the nose.
RailEnd rail_end(const MouthSpec& mouth, Real mouth_start) {
    const auto [back, out] = normalized(mouth.facing);
    // The fillet of a corner of 90 + a degrees, {back, out} = {sin a, cos a}, begins
    // r tan((90 - a) / 2) = r (1 - sin a) / cos a from the corner's point.
    const Real tangent = mouth.jaw_radius * (1 - back) / out;
    const Vec2 centre{mouth_start + tangent, mouth.jaw_radius};
    const Vec2 normal{out, back};
    RailEnd end;
    end.arc_centre = centre;
    end.facing_from = centre - mouth.jaw_radius * normal;
    end.facing_to = {mouth_start - kCushionWidth * back / out, kCushionWidth};
    end.facing_normal = normal;
    end.radius = mouth.jaw_radius;
    end.hole_radius = mouth.hole_radius;
    return end;
}

/// The mouth's line is half a width on this side of the crossing of the nose lines.
RailEnd corner_end(const MouthSpec& mouth) {
    RailEnd end = rail_end(mouth, mouth.width * kHalfSqrt2);
    const Real edge = (mouth.shelf - mouth.width / 2) * kHalfSqrt2;
    const Real hole = (mouth.shelf + mouth.hole_radius - mouth.width / 2) * kHalfSqrt2;
    end.hole = {-hole, hole};
    end.hole_edge = {-edge, edge};
    return end;
}

RailEnd side_end(const MouthSpec& mouth) {
    RailEnd end = rail_end(mouth, mouth.width / 2);
    end.hole = {0, mouth.shelf + mouth.hole_radius};
    end.hole_edge = {0, mouth.shelf};
    return end;
}

struct RailEnds {
    RailEnd corner;
    RailEnd side;

    explicit RailEnds(const Table& table)
        : corner(corner_end(table.mouths ? table.mouths->corner : kCornerMouth)),
          side(side_end(table.mouths ? table.mouths->side : kSideMouth)) {}
};

/// Where a rail end is on the table, in units of half the sides: the corner or the middle of a rail
/// that it is measured from, the way along the nose and the way out of the table. One coordinate of
/// `along` and of `out` is 0, the other 1 or -1, so mirror images lose nothing.
struct Jaw {
    RailEnd RailEnds::*end;
    Vec2 origin;
    Vec2 along;
    Vec2 out;
};

/// In the order of Rail, from kNorthWestJawN.
constexpr std::array<Jaw, 12> kJaws{{
    {&RailEnds::corner, {-1, 1}, {1, 0}, {0, 1}},
    {&RailEnds::corner, {-1, 1}, {0, -1}, {-1, 0}},
    {&RailEnds::side, {0, 1}, {-1, 0}, {0, 1}},
    {&RailEnds::side, {0, 1}, {1, 0}, {0, 1}},
    {&RailEnds::corner, {1, 1}, {-1, 0}, {0, 1}},
    {&RailEnds::corner, {1, 1}, {0, -1}, {1, 0}},
    {&RailEnds::corner, {1, -1}, {-1, 0}, {0, -1}},
    {&RailEnds::corner, {1, -1}, {0, 1}, {1, 0}},
    {&RailEnds::side, {0, -1}, {-1, 0}, {0, -1}},
    {&RailEnds::side, {0, -1}, {1, 0}, {0, -1}},
    {&RailEnds::corner, {-1, -1}, {1, 0}, {0, -1}},
    {&RailEnds::corner, {-1, -1}, {0, 1}, {-1, 0}},
}};

constexpr const Jaw& jaw_of(Rail rail) {
    return kJaws[static_cast<std::size_t>(rail) - static_cast<std::size_t>(kFirstJaw)];
}

/// The straight noses: each from one rail end to another.
struct Nose {
    Rail rail;
    Rail from;
    Rail to;
};

constexpr std::array<Nose, 6> kNoses{{
    {Rail::kNorth, Rail::kNorthWestJawN, Rail::kNorthJawW},
    {Rail::kNorth, Rail::kNorthJawE, Rail::kNorthEastJawN},
    {Rail::kEast, Rail::kNorthEastJawE, Rail::kSouthEastJawE},
    {Rail::kSouth, Rail::kSouthJawE, Rail::kSouthEastJawS},
    {Rail::kSouth, Rail::kSouthWestJawS, Rail::kSouthJawW},
    {Rail::kWest, Rail::kSouthWestJawW, Rail::kNorthWestJawW},
}};

Vec2 direction(const Jaw& jaw, Vec2 a) {
    return a.x * jaw.along + a.y * jaw.out;
}

/// `half` is half the table's sides.
Vec2 point(const Jaw& jaw, Vec2 half, Vec2 a) {
    return Vec2{jaw.origin.x * half.x, jaw.origin.y * half.y} + direction(jaw, a);
}

CushionLine nose_of(const Nose& nose, const RailEnds& ends, Vec2 half) {
    const Jaw& from = jaw_of(nose.from);
    const Jaw& to = jaw_of(nose.to);
    return {.from = point(from, half, {(ends.*from.end).arc_centre.x, 0}),
            .to = point(to, half, {(ends.*to.end).arc_centre.x, 0}),
            .normal = from.out,
            .rail = nose.rail};
}

CushionLine facing_of(const Jaw& jaw, const RailEnd& end, Vec2 half, Rail rail) {
    return {.from = point(jaw, half, end.facing_from),
            .to = point(jaw, half, end.facing_to),
            .normal = direction(jaw, end.facing_normal),
            .rail = rail};
}

CushionArc arc_of(const Jaw& jaw, const RailEnd& end, Vec2 half, Rail rail) {
    return {.centre = point(jaw, half, end.arc_centre),
            .radius = end.radius,
            .from = -jaw.out,
            .to = -direction(jaw, end.facing_normal),
            .rail = rail};
}

/// x, y: -1, 0 or 1, which corner or middle.
Hole hole_of(Pocket pocket, const RailEnd& end, Vec2 at, Vec2 half) {
    const Real y = at.y * (half.y + end.hole.y);
    if (at.x == 0) return {{0, y}, end.hole_radius, pocket};
    return {{at.x * (half.x + end.hole.y), y}, end.hole_radius, pocket};
}

/// The largest ball that gets through: facings close in on it, so the edge where it drops is the
/// narrowest place that it has to pass.
Real clearance(const RailEnd& end) {
    return dot(end.facing_from - end.hole_edge, end.facing_normal);
}

/// A ball of radius r that touches the end of a facing must be in the hole, or it could roll around
/// that end.
bool closed(const RailEnd& end, Real r) {
    const Vec2 last = end.facing_to - r * end.facing_normal - end.hole;
    return dot(last, last) < end.hole_radius * end.hole_radius;
}

/// What is wrong with one kind of mouth; empty if nothing.
std::string_view fault_of(const MouthSpec& mouth, const RailEnd& end) {
    if (!(mouth.facing.y > 0) || mouth.facing.x < 0)
        return "must have facings that run out of the table and not away from the pocket";
    if (!(end.facing_to.y > end.facing_from.y))
        return "has jaws that are rounder than its cushions are wide";
    // A disc is convex: true for the smallest and the largest ball, true for all between.
    if (!(clearance(end) > 0) || !closed(end, 0) || !closed(end, clearance(end)))
        return "has a hole that does not reach the ends of its facings";
    return {};
}

}  // namespace

PoolTable::PoolTable(const Table& table) {
    const Vec2 half{table.length / 2, table.width / 2};
    const RailEnds ends(table);
    for (std::size_t i = 0; i < kNoses.size(); ++i)
        lines_[i] = nose_of(kNoses[i], ends, half);
    for (std::size_t i = 0; i < kJaws.size(); ++i) {
        const auto rail = static_cast<Rail>(static_cast<std::size_t>(kFirstJaw) + i);
        const RailEnd& end = ends.*kJaws[i].end;
        lines_[kNoses.size() + i] = facing_of(kJaws[i], end, half, rail);
        arcs_[i] = arc_of(kJaws[i], end, half, rail);
    }
    holes_ = {hole_of(Pocket::kNorthWest, ends.corner, {-1, 1}, half),
              hole_of(Pocket::kNorth, ends.side, {0, 1}, half),
              hole_of(Pocket::kNorthEast, ends.corner, {1, 1}, half),
              hole_of(Pocket::kSouthEast, ends.corner, {1, -1}, half),
              hole_of(Pocket::kSouth, ends.side, {0, -1}, half),
              hole_of(Pocket::kSouthWest, ends.corner, {-1, -1}, half)};
    hole_depth_ = std::max({Real{0}, ends.corner.hole_radius - ends.corner.hole.y,
                            ends.side.hole_radius - ends.side.hole.y});
}

std::optional<MouthFault> fault_of_mouths(const Table& table) {
    const RailEnds ends(table);
    const Mouths mouths = table.mouths.value_or(Mouths{});
    if (const auto fault = fault_of(mouths.corner, ends.corner); !fault.empty())
        return MouthFault{"/mouths/corner", fault};
    if (const auto fault = fault_of(mouths.side, ends.side); !fault.empty())
        return MouthFault{"/mouths/side", fault};
    const Real corner = ends.corner.arc_centre.x;
    if (!(table.length / 2 > corner + ends.side.arc_centre.x && table.width / 2 > corner))
        return MouthFault{"", "is too small for its six mouths"};
    return std::nullopt;
}

bool fits_pool_table(const Table& table, Real ball_radius) {
    const RailEnds ends(table);
    return ball_radius < clearance(ends.corner) && ball_radius < clearance(ends.side);
}

}  // namespace poolhall
