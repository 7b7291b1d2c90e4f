#include "shared/table/playing_area.hpp"

#include "shared/table/pool_table.hpp"
#include "tests/shared/random.hpp"

#include <gtest/gtest.h>

namespace poolhall {
namespace {

constexpr double kRadius = 0.028575;
constexpr double kSlack = 1e-9;

Table pool_table() {
    Table table;
    table.pockets = PocketModel::kPool;
    return table;
}

bool is_on(const Table& table, Vec2 r) {
    return is_on_table(table, r, kRadius, kSlack);
}

TEST(PlayingArea, EndsAtUnbrokenRails) {
    const Vec2 edge = inset(Table{}, kRadius);
    EXPECT_TRUE(is_on(Table{}, edge));
    EXPECT_TRUE(is_on(Table{}, {-edge.x - 0.9e-9, 0}));
    EXPECT_FALSE(is_on(Table{}, {0, edge.y + 1.1e-9}));
    EXPECT_FALSE(is_on(Table{}, {5, 0}));
}

TEST(PlayingArea, HasNoEndOnAnEndlessCloth) {
    Table cloth;
    cloth.rails = false;
    EXPECT_TRUE(is_on(cloth, {1e6, -1e6}));
}

TEST(PlayingArea, ReachesIntoTheMouths) {
    const Table table = pool_table();
    EXPECT_TRUE(is_on(table, {1.24, 0.605}));
    EXPECT_TRUE(is_on(table, {1.25, 0.615})) << "on the shelf of NE";
    EXPECT_TRUE(is_on(table, {0, -0.62})) << "on the shelf of S";
    EXPECT_FALSE(is_on(table, {1.26, 0.625})) << "in the hole";
    EXPECT_FALSE(is_on(table, {0, 0.68})) << "in the hole";
    EXPECT_FALSE(is_on(table, {1.30, 0.72})) << "in the hole";
}

TEST(PlayingArea, EndsAtJawsAndFacings) {
    const Table table = pool_table();
    EXPECT_FALSE(is_on(table, {0.05, -0.62})) << "in the jaw";
    EXPECT_FALSE(is_on(table, {0.5, 0.62})) << "in the rail";
    EXPECT_FALSE(is_on(table, {0.5, 0.7})) << "behind the rail";
    EXPECT_FALSE(is_on(table, {1.45, 0.8})) << "behind the hole";
    EXPECT_FALSE(is_on(table, {-1.29, 0}));
    EXPECT_FALSE(is_on(table, {0, 3}));
}

TEST(PlayingArea, IsTheSameInAllFourQuarters) {
    const Table table = pool_table();
    testing::Random random(4);
    int inside = 0;
    for (int i = 0; i < 20000; ++i) {
        const double x = random.uniform(0, 1.4);
        const Vec2 r{x, random.uniform(0.5, 0.8)};
        const bool on = is_on(table, r);
        inside += on ? 1 : 0;
        EXPECT_EQ(on, is_on(table, {-r.x, r.y}));
        EXPECT_EQ(on, is_on(table, {r.x, -r.y}));
        EXPECT_EQ(on, is_on(table, -r));
    }
    EXPECT_GT(inside, 1000);
}

TEST(PlayingArea, IsClearOfEveryPieceOfRubber) {
    const Table table = pool_table();
    const PoolTable pool(table);
    testing::Random random(5);
    for (int i = 0; i < 20000; ++i) {
        const double x = random.uniform(-1.4, 1.4);
        const Vec2 r{x, random.uniform(-0.8, 0.8)};
        if (!is_on(table, r)) continue;
        for (const CushionArc& arc : pool.arcs())
            EXPECT_TRUE(!within(arc, r - arc.centre) ||
                        norm(r - arc.centre) >= arc.radius + kRadius - kSlack);
        for (const CushionLine& line : pool.lines()) {
            EXPECT_TRUE(!within(line, r) || dot(line.from - r, line.normal) >= kRadius - kSlack);
        }
        for (const Hole& hole : pool.holes())
            EXPECT_GT(norm(r - hole.centre), hole.radius);
    }
}

}  // namespace
}  // namespace poolhall
