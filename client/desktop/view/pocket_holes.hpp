#pragma once

#include "shared/table/table.hpp"

#include <vector>

namespace poolhall::client {

/// Where a table's pockets are drawn: about where a ball's centre is when it goes down.
struct PocketHole {
    Vec2 centre;        ///< m
    double radius = 0;  ///< m
};

/// The holes of every model of pockets, in the order of Pocket or of Table::circles.
/// `ball_radius` in metres.
[[nodiscard]] std::vector<PocketHole> pocket_holes(const Table& table, double ball_radius);

}  // namespace poolhall::client
