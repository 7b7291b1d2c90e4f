#include "client/desktop/view/cushions.hpp"

#include "shared/table/playing_area.hpp"
#include "shared/table/pool_table.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace poolhall::client {
namespace {

constexpr double kBall = 0.028575;  // m
const Table kPool{2.54, 1.27, true, PocketModel::kPool};

SDL_FPoint in_balls(Vec2 r) {
    return {static_cast<float>(r.x / kBall), static_cast<float>(r.y / kBall)};
}

bool in_a_hole(const PoolTable& pool, Vec2 r) {
    for (const Hole& hole : pool.holes()) {
        if (norm(r - hole.centre) <= hole.radius) return true;
    }
    return false;
}

TEST(Cushions, PoolTablesRubberIsWhereThePhysicsHasIt) {
    const Cushions cushions(kPool, kBall);
    const PoolTable pool(kPool);
    constexpr double kGrain = 1e-4;      // m; radius of a ball that gets everywhere
    constexpr float kFlattened = 0.01F;  // ball radii, where arcs are drawn as polygons
    int inside = 0;
    int outside = 0;
    for (double x = -1.31; x <= 1.31; x += 0.0071) {
        for (double y = -0.68; y <= 0.68; y += 0.0053) {
            const float distance = cushions.at(in_balls({x, y})).outside;
            if (std::abs(distance) < kFlattened || in_a_hole(pool, {x, y})) continue;
            const bool free = is_on_table(kPool, {x, y}, kGrain, 0);
            const bool behind = std::abs(x) > 1.27 + 0.0508 || std::abs(y) > 0.635 + 0.0508;
            if (behind) continue;
            EXPECT_EQ(free, distance > 0) << x << ' ' << y << ": " << distance;
            ++(free ? outside : inside);
        }
    }
    EXPECT_GT(inside, 1000);
    EXPECT_GT(outside, 10000);
}

TEST(Cushions, FacesOfAPoolTablesJawsLookIntoTheMouth) {
    const Cushions cushions(kPool, kBall);
    for (const CushionLine& line : PoolTable(kPool).lines()) {
        const auto place = cushions.at(in_balls(0.5 * (line.from + line.to)));
        EXPECT_NEAR(place.outside, 0, 1e-4) << name(line.rail);
        EXPECT_NEAR(place.normal.x, -line.normal.x, 1e-5) << name(line.rail);
        EXPECT_NEAR(place.normal.y, -line.normal.y, 1e-5) << name(line.rail);
    }
}

TEST(Cushions, RailsWithoutMouthsAreUnbroken) {
    for (const PocketModel model : {PocketModel::kNone, PocketModel::kCircles}) {
        const Cushions cushions({2, 1, true, model}, kBall);
        for (double x = -1; x <= 1; x += 0.01) {
            EXPECT_NEAR(cushions.at(in_balls({x, 0.5 + kBall})).outside, -1, 1e-4) << x;
            EXPECT_NEAR(cushions.at(in_balls({x, 0.5 - kBall})).outside,
                        std::min(1.0, (1 - std::abs(x)) / kBall), 1e-4)
                << x;
        }
    }
}

TEST(Cushions, OriginalGamesRailsOpenAtItsSixPockets) {
    const Cushions cushions({1.55, 0.715, true, PocketModel::kEndGame}, kBall);
    for (const Vec2 pocket : {Vec2{0, 0.3575}, Vec2{0.775, 0.3575}, Vec2{-0.775, -0.3575}})
        EXPECT_GT(cushions.at(in_balls(pocket)).outside, 1) << pocket.x;
    EXPECT_NEAR(cushions.at(in_balls({0.4, 0.3575 + kBall})).outside, -1, 1e-4);
    EXPECT_NEAR(cushions.at(in_balls({0.775 + kBall, 0})).outside, -1, 1e-4);
}

TEST(Cushions, EndlessClothHasNone) {
    EXPECT_GT(Cushions({2, 1, false, PocketModel::kNone}, kBall).at({0, 900}).outside, 1000);
}

}  // namespace
}  // namespace poolhall::client
