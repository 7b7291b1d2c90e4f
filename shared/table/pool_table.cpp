#include "shared/table/pool_table.hpp"

namespace poolhall {

namespace {

constexpr Real kHalfSqrt2 = 0.70710678118654752;

/// How far from the crossing of a corner's two nose lines its mouth begins, and how far from the
/// middle of a long rail a side pocket's, along the rail; m.
constexpr Real kCornerMouthStart = kCornerMouth.width * kHalfSqrt2;
constexpr Real kSideMouthStart = kSideMouth.width / 2;

/// How far from the crossing of its nose lines a corner's hole is, along each axis, outwards; m.
/// The mouth's line is half a width on this side of the crossing.
constexpr Real kCornerHole =
    (kCornerMouth.shelf + kCornerMouth.hole_radius - kCornerMouth.width / 2) * kHalfSqrt2;
/// How far outside the nose line a side hole is, m.
constexpr Real kSideHole = kSideMouth.shelf + kSideMouth.hole_radius;

/// One rail end as seen from the rail: x runs along the nose away from the pocket, from the
/// crossing of a corner's nose lines or from the middle of a long rail; y out of the table.
struct RailEnd {
    Vec2 arc_centre;  ///< x is also where the straight nose begins
    Vec2 facing_from;
    Vec2 facing_to;
    Vec2 facing_normal;
    Real radius;
};

constexpr RailEnd rail_end(const MouthSpec& mouth, Real mouth_start) {
    const auto [back, out] = mouth.facing;
    // The fillet of a corner of 90 + a degrees, {back, out} = {sin a, cos a}, begins
    // r tan((90 - a) / 2) = r (1 - sin a) / cos a from the corner's point.
    const Real tangent = mouth.jaw_radius * (1 - back) / out;
    const Vec2 centre{mouth_start + tangent, mouth.jaw_radius};
    const Vec2 normal{out, back};
    return {.arc_centre = centre,
            .facing_from = centre - mouth.jaw_radius * normal,
            .facing_to = {mouth_start - kCushionWidth * back / out, kCushionWidth},
            .facing_normal = normal,
            .radius = mouth.jaw_radius};
}

constexpr RailEnd kCornerEnd = rail_end(kCornerMouth, kCornerMouthStart);
constexpr RailEnd kSideEnd = rail_end(kSideMouth, kSideMouthStart);

/// Where a rail end is on the table, in units of half the sides: the corner or the middle of a rail
/// that it is measured from, the way along the nose and the way out of the table. One coordinate of
/// `along` and of `out` is 0, the other 1 or -1, so mirror images lose nothing.
struct Jaw {
    const RailEnd* end;
    Vec2 origin;
    Vec2 along;
    Vec2 out;
};

/// In the order of Rail, from kNorthWestJawN.
constexpr std::array<Jaw, 12> kJaws{{
    {&kCornerEnd, {-1, 1}, {1, 0}, {0, 1}},
    {&kCornerEnd, {-1, 1}, {0, -1}, {-1, 0}},
    {&kSideEnd, {0, 1}, {-1, 0}, {0, 1}},
    {&kSideEnd, {0, 1}, {1, 0}, {0, 1}},
    {&kCornerEnd, {1, 1}, {-1, 0}, {0, 1}},
    {&kCornerEnd, {1, 1}, {0, -1}, {1, 0}},
    {&kCornerEnd, {1, -1}, {-1, 0}, {0, -1}},
    {&kCornerEnd, {1, -1}, {0, 1}, {1, 0}},
    {&kSideEnd, {0, -1}, {-1, 0}, {0, -1}},
    {&kSideEnd, {0, -1}, {1, 0}, {0, -1}},
    {&kCornerEnd, {-1, -1}, {1, 0}, {0, -1}},
    {&kCornerEnd, {-1, -1}, {0, 1}, {-1, 0}},
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

CushionLine nose_of(const Nose& nose, Vec2 half) {
    const Jaw& from = jaw_of(nose.from);
    const Jaw& to = jaw_of(nose.to);
    return {.from = point(from, half, {from.end->arc_centre.x, 0}),
            .to = point(to, half, {to.end->arc_centre.x, 0}),
            .normal = from.out,
            .rail = nose.rail};
}

CushionLine facing_of(const Jaw& jaw, Vec2 half, Rail rail) {
    return {.from = point(jaw, half, jaw.end->facing_from),
            .to = point(jaw, half, jaw.end->facing_to),
            .normal = direction(jaw, jaw.end->facing_normal),
            .rail = rail};
}

CushionArc arc_of(const Jaw& jaw, Vec2 half, Rail rail) {
    return {.centre = point(jaw, half, jaw.end->arc_centre),
            .radius = jaw.end->radius,
            .from = -jaw.out,
            .to = -direction(jaw, jaw.end->facing_normal),
            .rail = rail};
}

/// x, y: -1, 0 or 1, which corner or middle.
Hole hole_of(Pocket pocket, Real x, Real y, Vec2 half) {
    if (x == 0) return {{0, y * (half.y + kSideHole)}, kSideMouth.hole_radius, pocket};
    return {
        {x * (half.x + kCornerHole), y * (half.y + kCornerHole)}, kCornerMouth.hole_radius, pocket};
}

constexpr Vec2 kCornerHoleSeen{-kCornerHole, kCornerHole};
constexpr Vec2 kSideHoleSeen{0, kSideHole};

/// The largest ball that gets through: facings close in on it, so the edge where it drops is the
/// narrowest place that it has to pass. `inwards`: unit, from the hole to the mouth.
constexpr Real clearance(const RailEnd& end, Vec2 hole, Real hole_radius, Vec2 inwards) {
    return dot(end.facing_from - (hole + hole_radius * inwards), end.facing_normal);
}

constexpr Real kCornerClearance =
    clearance(kCornerEnd, kCornerHoleSeen, kCornerMouth.hole_radius, {kHalfSqrt2, -kHalfSqrt2});
constexpr Real kSideClearance = clearance(kSideEnd, kSideHoleSeen, kSideMouth.hole_radius, {0, -1});

/// A ball of radius r that touches the end of a facing must be in the hole, or it could roll around
/// that end.
constexpr bool closed(const RailEnd& end, Vec2 hole, Real hole_radius, Real r) {
    const Vec2 last = end.facing_to - r * end.facing_normal - hole;
    return dot(last, last) < hole_radius * hole_radius;
}

// A disc is convex: true for the smallest and the largest ball, true for all between.
static_assert(closed(kCornerEnd, kCornerHoleSeen, kCornerMouth.hole_radius, 0) &&
              closed(kCornerEnd, kCornerHoleSeen, kCornerMouth.hole_radius, kCornerClearance));
static_assert(closed(kSideEnd, kSideHoleSeen, kSideMouth.hole_radius, 0) &&
              closed(kSideEnd, kSideHoleSeen, kSideMouth.hole_radius, kSideClearance));

}  // namespace

PoolTable::PoolTable(const Table& table) {
    const Vec2 half{table.length / 2, table.width / 2};
    for (std::size_t i = 0; i < kNoses.size(); ++i)
        lines_[i] = nose_of(kNoses[i], half);
    for (std::size_t i = 0; i < kJaws.size(); ++i) {
        const auto rail = static_cast<Rail>(static_cast<std::size_t>(kFirstJaw) + i);
        lines_[kNoses.size() + i] = facing_of(kJaws[i], half, rail);
        arcs_[i] = arc_of(kJaws[i], half, rail);
    }
    holes_ = {hole_of(Pocket::kNorthWest, -1, 1, half), hole_of(Pocket::kNorth, 0, 1, half),
              hole_of(Pocket::kNorthEast, 1, 1, half),  hole_of(Pocket::kSouthEast, 1, -1, half),
              hole_of(Pocket::kSouth, 0, -1, half),     hole_of(Pocket::kSouthWest, -1, -1, half)};
}

bool is_large_enough_for_pool(const Table& table) {
    const Real corner = kCornerEnd.arc_centre.x;
    return table.length / 2 > corner + kSideEnd.arc_centre.x && table.width / 2 > corner;
}

bool fits_pool_table(Real ball_radius) {
    return ball_radius < kCornerClearance && ball_radius < kSideClearance;
}

}  // namespace poolhall
