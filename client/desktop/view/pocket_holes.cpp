#include "client/desktop/view/pocket_holes.hpp"

#include "shared/table/pockets.hpp"
#include "shared/table/pool_table.hpp"

namespace poolhall::client {
namespace {

// Of the original game, whose pockets are places and no holes; in ball radii.
constexpr double kCornerRadius = 1.9;
constexpr double kSideRadius = 1.55;

std::vector<PocketHole> end_game_holes(const Table& table, double ball_radius) {
    std::vector<PocketHole> holes;
    for (int i = 0; i < kPocketCount; ++i) {
        const auto pocket = static_cast<Pocket>(i);
        const bool side = pocket == Pocket::kNorth || pocket == Pocket::kSouth;
        holes.push_back({EndGamePocketMap::mouth(table, pocket),
                         (side ? kSideRadius : kCornerRadius) * ball_radius});
    }
    return holes;
}

}  // namespace

std::vector<PocketHole> pocket_holes(const Table& table, double ball_radius) {
    std::vector<PocketHole> holes;
    switch (table.pockets) {
        case PocketModel::kNone:
            break;
        case PocketModel::kEndGame:
            return end_game_holes(table, ball_radius);
        case PocketModel::kPool: {
            const PoolTable pool(table);
            for (const Hole& hole : pool.holes())
                holes.push_back({hole.centre, hole.radius});
            break;
        }
        case PocketModel::kCircles:
            for (const PocketCircle& circle : table.circles)
                holes.push_back({circle.centre, circle.radius});
            break;
    }
    return holes;
}

}  // namespace poolhall::client
