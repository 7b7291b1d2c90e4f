#include "shared/table/playing_area.hpp"

#include "shared/table/pool_table.hpp"

#include <algorithm>

namespace poolhall {

namespace {

/// Whether a ray from `point` along +x crosses the edge.
bool ray_crosses(Vec2 point, Vec2 from, Vec2 to) {
    if ((from.y > point.y) == (to.y > point.y)) return false;
    return point.x < from.x + (point.y - from.y) / (to.y - from.y) * (to.x - from.x);
}

/// Whether r lies in the polygon of noses, facings, chords of the rail ends, and lines across the
/// mouths' back: a ray from there crosses its edges an odd number of times.
bool in_outline(const PoolTable& table, Vec2 r) {
    constexpr std::size_t kFirstFacing = 6;
    bool inside = false;
    const auto cross_edge = [&](Vec2 from, Vec2 to) {
        inside = inside != ray_crosses(r, from, to);
    };
    for (const CushionLine& line : table.lines())
        cross_edge(line.from, line.to);
    for (const CushionArc& arc : table.arcs())
        cross_edge(arc.centre + arc.radius * arc.from, arc.centre + arc.radius * arc.to);
    const auto facings = table.lines().subspan(kFirstFacing);
    for (std::size_t i = 0; i < facings.size(); i += 2)  // the two of one mouth
        cross_edge(facings[i].to, facings[i + 1].to);
    return inside;
}

/// Whether a ball in the outline reaches no deeper than `slack` into rubber.
bool clear_of_rubber(const PoolTable& table, Vec2 r, Real reach, Real slack) {
    const Real least = reach - slack;
    const bool lines =
        std::all_of(table.lines().begin(), table.lines().end(), [&](const CushionLine& line) {
            return !within(line, r) || dot(line.from - r, line.normal) >= least;
        });
    return lines && std::all_of(table.arcs().begin(), table.arcs().end(), [&](const auto& arc) {
               const Vec2 out = r - arc.centre;
               return !within(arc, out) || norm(out) - arc.radius >= least;
           });
}

bool in_hole(const PoolTable& table, Vec2 r) {
    return std::any_of(table.holes().begin(), table.holes().end(),
                       [&](const Hole& hole) { return norm(r - hole.centre) <= hole.radius; });
}

}  // namespace

bool is_on_table(const Table& table, Vec2 r, Real radius, Real slack) {
    if (!table.rails) return true;
    const Vec2 edge = inset(table, radius);
    const bool inside = abs(r.x) <= edge.x + slack && abs(r.y) <= edge.y + slack;
    if (table.pockets != PocketModel::kPool) return inside;
    const PoolTable pool(table);
    if (in_hole(pool, r)) return false;
    return inside ||
           (in_outline(pool, r) && clear_of_rubber(pool, r, rail_reach(table, radius), slack));
}

}  // namespace poolhall
