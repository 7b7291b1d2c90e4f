#include "shared/physics/search/cushion_map.hpp"

#include <algorithm>

namespace poolhall {

namespace {

Box box_of(Vec2 a, Vec2 b) {
    return {std::min(a.x, b.x), std::max(a.x, b.x), std::min(a.y, b.y), std::max(a.y, b.y)};
}

/// Of an arc of less than 90 degrees: its ends, and where it turns beyond them along an axis.
Box box_of(const CushionArc& arc) {
    const Vec2 from = arc.centre + arc.radius * arc.from;
    const Vec2 to = arc.centre + arc.radius * arc.to;
    Box box = box_of(from, to);
    for (const Vec2 axis : {Vec2{1, 0}, Vec2{-1, 0}, Vec2{0, 1}, Vec2{0, -1}}) {
        const Vec2 top = arc.centre + arc.radius * axis;
        if (within(arc, axis)) box = united(box, box_of(top, top));
    }
    return box;
}

Box box_of(const Hole& hole) {
    const Vec2 reach{hole.radius, hole.radius};
    return box_of(hole.centre - reach, hole.centre + reach);
}

}  // namespace

CushionMap::CushionMap(const Table& table) : table_(table) {
    const auto lines = table_.lines();
    for (std::size_t i = 0; i < kNoseCount; ++i)
        noses_[i] = box_of(lines[i].from, lines[i].to);
    for (std::size_t place = 0; place < mouths_.size(); ++place) {
        Mouth& mouth = mouths_[place];
        mouth.hole = box_of(table_.holes()[place]);
        mouth.all = mouth.hole;
        for (std::size_t i = 0; i < 2; ++i) {
            const CushionLine& facing = lines[kNoseCount + 2 * place + i];
            mouth.facings[i] = box_of(facing.from, facing.to);
            mouth.arcs[i] = box_of(table_.arcs()[2 * place + i]);
            mouth.all = united(mouth.all, united(mouth.facings[i], mouth.arcs[i]));
        }
    }
}

}  // namespace poolhall
