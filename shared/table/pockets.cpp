#include "shared/table/pockets.hpp"

namespace poolhall {

namespace {

struct Interval {
    Real from;
    Real to;
};

/// When x + v t >= edge, within [0, time]; empty (from > to) if never.
Interval time_above(Real x, Real v, Real edge, Real time) {
    if (x >= edge) return {0, v < 0 ? (edge - x) / v : time};
    if (v <= 0) return {1, 0};
    return {(edge - x) / v, time};
}

Interval both(Interval a, Interval b) {
    return {a.from > b.from ? a.from : b.from, a.to < b.to ? a.to : b.to};
}

/// column -1, 0, 1 from west to east; north or south.
Pocket pocket_of(int column, bool north) {
    if (column == 0) return north ? Pocket::kNorth : Pocket::kSouth;
    if (column < 0) return north ? Pocket::kNorthWest : Pocket::kSouthWest;
    return north ? Pocket::kNorthEast : Pocket::kSouthEast;
}

}  // namespace

EndGamePocketMap::EndGamePocketMap(const Table& table, Real radius)
    : corner_x_(table.length / 2 - 1.5 * radius),
      near_rail_y_(table.width / 2 - 1.5 * radius),
      centre_x_(0.75 * radius) {}

std::optional<Pocket> EndGamePocketMap::at(Vec2 r) const {
    if (abs(r.y) < near_rail_y_) return std::nullopt;
    if (abs(r.x) <= centre_x_) return pocket_of(0, r.y > 0);
    if (abs(r.x) < corner_x_) return std::nullopt;
    return pocket_of(r.x < 0 ? -1 : 1, r.y > 0);
}

std::optional<Capture> EndGamePocketMap::first_capture(Vec2 r, Vec2 v, Real time) const {
    // Most ticks pass far from the long rails.
    if (abs(r.y) + abs(v.y) * time < near_rail_y_) return std::nullopt;
    std::optional<Capture> first;
    for (const bool north : {true, false}) {
        const Real y_sign = north ? 1 : -1;
        const Interval near_rail = time_above(y_sign * r.y, y_sign * v.y, near_rail_y_, time);
        if (near_rail.from > near_rail.to || near_rail.from > time) continue;
        for (const int column : {-1, 0, 1}) {
            const Interval in_column =
                column == 0 ? both(time_above(r.x, v.x, -centre_x_, time),
                                   time_above(-r.x, -v.x, -centre_x_, time))
                            : time_above(column * r.x, column * v.x, corner_x_, time);
            const Interval inside = both(near_rail, in_column);
            if (inside.from > inside.to || inside.from > time) continue;
            if (!first || inside.from < first->t)
                first = Capture{inside.from, pocket_of(column, north)};
        }
    }
    return first;
}

Vec2 EndGamePocketMap::mouth(const Table& table, Pocket pocket) {
    const Real x = table.length / 2;
    const Real y = table.width / 2;
    switch (pocket) {
        case Pocket::kNorthWest:
            return {-x, y};
        case Pocket::kNorth:
            return {0, y};
        case Pocket::kNorthEast:
            return {x, y};
        case Pocket::kSouthEast:
            return {x, -y};
        case Pocket::kSouth:
            return {0, -y};
        case Pocket::kSouthWest:
            return {-x, -y};
    }
    return {};
}

}  // namespace poolhall
