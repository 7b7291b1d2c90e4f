#include "shared/table/pool_table.hpp"

#include "shared/table/ball.hpp"
#include "tests/shared/random.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace poolhall {
namespace {

constexpr double kInch = 0.0254;
constexpr double kRadius = BallSpec{}.radius;
const Table kTable{};
const PoolTable kPool(kTable);

const CushionLine& facing(Rail rail) {
    return *std::find_if(kPool.lines().begin(), kPool.lines().end(),
                         [&](const CushionLine& line) { return line.rail == rail; });
}

const CushionArc& arc(Rail rail) {
    return *std::find_if(kPool.arcs().begin(), kPool.arcs().end(),
                         [&](const CushionArc& a) { return a.rail == rail; });
}

const Hole& hole(Pocket pocket) {
    return kPool.holes()[static_cast<std::size_t>(pocket)];
}

/// Where the facing's line crosses the nose's line: the pointed lip that mouths are measured from.
Vec2 lip(Rail jaw, Rail rail) {
    const CushionLine& a = facing(jaw);
    const CushionLine& b = facing(rail);
    const Vec2 along = a.to - a.from;
    const double s = dot(b.from - a.from, b.normal) / dot(along, b.normal);
    return a.from + s * along;
}

double distance_to(const CushionLine& line, Vec2 p) {
    const Vec2 along = line.to - line.from;
    const double s = std::clamp(dot(p - line.from, along) / dot(along, along), 0.0, 1.0);
    return norm(p - (line.from + s * along));
}

/// To the rubber's surface, by no predicate of the code under test.
double distance_to_rubber(const PoolTable& pool, Vec2 p) {
    double least = std::numeric_limits<double>::infinity();
    for (const CushionLine& line : pool.lines())
        least = std::min(least, distance_to(line, p));
    for (const CushionArc& a : pool.arcs()) {
        const Vec2 n = normalized(p - a.centre);
        const Vec2 middle = normalized(a.from + a.to);
        const bool facing_it = dot(n, middle) >= dot(a.from, middle);
        if (facing_it) least = std::min(least, norm(p - a.centre) - a.radius);
    }
    return least;
}

TEST(PoolTable, JawsAreNamedAfterTheirPocketAndRail) {
    for (int i = 0; i < kRailCount; ++i) {
        const std::string_view rail = name(static_cast<Rail>(i));
        const bool jaw = i >= static_cast<int>(kFirstJaw);
        EXPECT_EQ(jaw, rail.find('.') != std::string_view::npos) << rail;
    }
    for (const Hole& h : kPool.holes()) {
        int jaws = 0;
        for (const CushionArc& a : kPool.arcs()) {
            if (norm(a.centre - h.centre) > 0.2) continue;
            ++jaws;
            const std::string_view jaw = name(a.rail);
            EXPECT_EQ(name(h.pocket), jaw.substr(0, jaw.find('.')));
        }
        EXPECT_EQ(2, jaws);
    }
    EXPECT_LT(arc(Rail::kNorthJawW).centre.x, 0);
    EXPECT_EQ("N.W", name(Rail::kNorthJawW));
    EXPECT_LT(arc(Rail::kSouthWestJawS).centre.y, -kTable.width / 2);
    EXPECT_EQ("SW.S", name(Rail::kSouthWestJawS));
}

TEST(PoolTable, MouthsAreWithinTheSpecificationsOfTheWpa) {
    const double corner =
        norm(lip(Rail::kNorthEastJawN, Rail::kNorth) - lip(Rail::kNorthEastJawE, Rail::kEast));
    EXPECT_NEAR(4.5625 * kInch, corner, 1e-12);
    const double side =
        norm(lip(Rail::kNorthJawE, Rail::kNorth) - lip(Rail::kNorthJawW, Rail::kNorth));
    EXPECT_NEAR(5.0625 * kInch, side, 1e-12);
    // The rubber's angle at the lip, 180 degrees less that between the normals.
    const double degree = std::acos(-1.0) / 180;
    const Vec2 corner_normal = facing(Rail::kNorthEastJawN).normal;
    EXPECT_NEAR(142, 180 - std::acos(corner_normal.y) / degree, 1e-12);
    EXPECT_NEAR(104, 180 - std::acos(facing(Rail::kNorthJawE).normal.y) / degree, 1e-12);
}

TEST(PoolTable, BallsDropOneShelfBehindTheMouth) {
    const Vec2 a = lip(Rail::kNorthEastJawN, Rail::kNorth);
    const Vec2 b = lip(Rail::kNorthEastJawE, Rail::kEast);
    const Hole& corner = hole(Pocket::kNorthEast);
    EXPECT_NEAR(1.625 * kInch, norm(corner.centre - 0.5 * (a + b)) - corner.radius, 1e-12);
    const Hole& side = hole(Pocket::kNorth);
    EXPECT_NEAR(0.1875 * kInch, side.centre.y - kTable.width / 2 - side.radius, 1e-12);
}

TEST(PoolTable, NormalsAreUnitAndPointIntoTheRubber) {
    for (const CushionLine& line : kPool.lines()) {
        EXPECT_NEAR(1, norm(line.normal), 1e-15);
        EXPECT_NEAR(0, dot(normalized(line.to - line.from), line.normal), 1e-14);
        // Seen from where balls are: the table's middle, or the edge where the nearest hole begins.
        Vec2 ball;
        for (const Hole& h : kPool.holes()) {
            if (line.rail >= kFirstJaw && norm(h.centre - line.to) < 2 * h.radius)
                ball = h.centre - h.radius * normalized(h.centre);
        }
        EXPECT_GT(dot(line.from - ball, line.normal), 0) << name(line.rail);
    }
}

TEST(PoolTable, EveryArcMeetsItsTwoLinesWithoutAKink) {
    for (const CushionArc& a : kPool.arcs()) {
        int joints = 0;
        for (const CushionLine& line : kPool.lines()) {
            for (const Vec2 end : {line.from, line.to}) {
                for (const Vec2 side : {a.from, a.to}) {
                    if (norm(a.centre + a.radius * side - end) > 1e-12) continue;
                    ++joints;
                    EXPECT_NEAR(0, norm(line.normal + side), 1e-15) << name(a.rail);
                }
            }
        }
        EXPECT_EQ(2, joints) << name(a.rail);
        EXPECT_GT(dot(a.from, a.to), 0) << "under 90 degrees";
    }
}

bool contains(std::span<const CushionLine> lines, const CushionLine& line) {
    return std::any_of(lines.begin(), lines.end(), [&](const CushionLine& other) {
        return other.normal == line.normal && ((other.from == line.from && other.to == line.to) ||
                                               (other.from == line.to && other.to == line.from));
    });
}

TEST(PoolTable, MirrorImagesAreExact) {
    for (const Table& table : {kTable, Table{.length = 2.3371, .width = 1.1683},
                               Table{.length = 1.55019375, .width = 0.7197328125}}) {
        const PoolTable pool(table);
        for (const Vec2 s : {Vec2{-1, 1}, Vec2{1, -1}}) {
            const auto mirrored = [&](Vec2 a) { return Vec2{s.x * a.x, s.y * a.y}; };
            for (const CushionLine& l : pool.lines())
                EXPECT_TRUE(contains(
                    pool.lines(), {mirrored(l.from), mirrored(l.to), mirrored(l.normal), l.rail}));
            for (const CushionArc& a : pool.arcs())
                EXPECT_TRUE(std::any_of(pool.arcs().begin(), pool.arcs().end(), [&](auto& b) {
                    return b.centre == mirrored(a.centre) && b.from == mirrored(a.from) &&
                           b.to == mirrored(a.to) && b.radius == a.radius;
                }));
            for (const Hole& h : pool.holes())
                EXPECT_TRUE(std::any_of(pool.holes().begin(), pool.holes().end(), [&](auto& b) {
                    return b.centre == mirrored(h.centre) && b.radius == h.radius;
                }));
        }
    }
}

/// Unit, from the mouth to its hole.
Vec2 outwards(const Hole& h) {
    const double y = h.centre.y < 0 ? -1 : 1;
    if (h.centre.x == 0) return {0, y};
    return normalized(Vec2{h.centre.x < 0 ? -1.0 : 1.0, y});
}

TEST(PoolTable, ABallGoesStraightThroughEachMouth) {
    for (const Hole& h : kPool.holes()) {
        for (double s = 0.3; s > h.radius; s -= 1e-4)
            ASSERT_GT(distance_to_rubber(kPool, h.centre - s * outwards(h)), kRadius);
    }
}

TEST(PoolTable, TwoBallsAbreastDropIntoSidePocketsOnly) {
    for (const Hole& h : kPool.holes()) {
        const Vec2 out = outwards(h);
        const Vec2 across{-out.y, out.x};
        const Vec2 edge = h.centre - h.radius * out;
        const bool fits = distance_to_rubber(kPool, edge + kRadius * across) > kRadius;
        EXPECT_EQ(h.centre.x == 0, fits) << name(h.pocket);
    }
}

TEST(PoolTable, BallsThatPassAStraightRailOrAMouthAlongItAreNotCaptured) {
    const double y = kTable.width / 2 - kRadius;
    for (double x = -kTable.length / 2 + kRadius; x <= kTable.length / 2 - kRadius; x += 1e-4) {
        for (const Hole& h : kPool.holes())
            ASSERT_GT(norm(Vec2{x, y} - h.centre), h.radius) << x;
    }
}

TEST(PoolTable, EveryJointIsCoveredOnWhicheverSideRoundingPutsTheBall) {
    for (const CushionArc& a : kPool.arcs()) {
        for (const CushionLine& line : kPool.lines()) {
            for (const Vec2 side : {a.from, a.to}) {
                const Vec2 joint = a.centre + a.radius * side;
                if (norm(joint - line.from) > 1e-12 && norm(joint - line.to) > 1e-12) continue;
                const Vec2 along{-side.y, side.x};
                for (int i = -1000; i <= 1000; ++i) {
                    const Vec2 ball = joint + kRadius * side + (i * 1e-15) * along;
                    ASSERT_TRUE(within(a, ball - a.centre));
                    const Vec2 away = joint + kRadius * side + (i * 1e-6 + 5e-7) * along;
                    ASSERT_NE(within(line, away), within(a, away - a.centre));
                }
            }
        }
    }
}

TEST(PoolTable, SectorsDoNotDependOnTheLengthOfTheDirection) {
    for (const CushionArc& a : kPool.arcs()) {
        const Vec2 middle = a.from + a.to;
        for (const double length : {1e-100, 1.0, 1e100}) {
            EXPECT_TRUE(within(a, length * middle));
            EXPECT_TRUE(within(a, length * a.from));
            EXPECT_TRUE(within(a, length * a.to));
            EXPECT_FALSE(within(a, -length * middle));
            EXPECT_FALSE(within(a, length * (a.from - a.to)));
            EXPECT_FALSE(within(a, length * (a.to - a.from)));
        }
    }
}

TEST(PoolTable, TablesShorterThanTheirMouthsAndBallsWiderThanThemAreRefused) {
    EXPECT_FALSE(fault_of_mouths(kTable));
    EXPECT_FALSE(fault_of_mouths({.length = 0.3016, .width = 0.1667}));
    EXPECT_TRUE(fault_of_mouths({.length = 0.3014, .width = 0.1667}));
    EXPECT_TRUE(fault_of_mouths({.length = 0.3016, .width = 0.1666}));
    EXPECT_TRUE(fits_pool_table(kTable, kRadius));
    EXPECT_TRUE(fits_pool_table(kTable, 0.05248));
    EXPECT_FALSE(fits_pool_table(kTable, 0.05249));
    EXPECT_FALSE(fits_pool_table(kTable, std::numeric_limits<double>::quiet_NaN()));
}

/// A ball's centre that goes straight on and is thrown back like light by everything it touches.
class Path {
  public:
    Path(const PoolTable& pool, double radius, Vec2 r, Vec2 v)
        : pool_(&pool), radius_(radius), r_(r), v_(normalized(v)) {}

    [[nodiscard]] Vec2 place() const { return r_; }

    /// To the next contact and away from it; false if the ball drops into a hole before.
    bool advance() {
        double contact = std::numeric_limits<double>::infinity();
        Vec2 normal;
        for (const CushionLine& line : pool_->lines()) {
            const double speed = dot(v_, line.normal);
            if (speed <= 0) continue;
            const double gap = dot(line.from - r_, line.normal) - radius_;
            if (gap < -1e-9) continue;  // behind the rubber's front
            const double t = std::max(0.0, gap / speed);
            if (t >= contact || !within(line, r_ + t * v_)) continue;
            contact = t;
            normal = line.normal;
        }
        for (const CushionArc& a : pool_->arcs()) {
            const double t = time_to(a.centre, a.radius + radius_);
            const Vec2 direction = r_ + t * v_ - a.centre;
            if (t >= contact || !within(a, direction)) continue;
            contact = t;
            normal = -normalized(direction);
        }
        double drop = std::numeric_limits<double>::infinity();
        for (const Hole& h : pool_->holes())
            drop = std::min(drop, time_to(h.centre, h.radius));
        escaped_ = !std::isfinite(contact) && !std::isfinite(drop);
        r_ = r_ + std::min(contact, drop) * v_;
        if (drop <= contact) return false;
        v_ = normalized(v_ - (2 * dot(v_, normal)) * normal);
        return true;
    }

    [[nodiscard]] bool escaped() const { return escaped_; }

  private:
    /// Until the centre enters the circle; infinite if it does not.
    [[nodiscard]] double time_to(Vec2 centre, double radius) const {
        const Vec2 c = centre - r_;
        const double b = dot(c, v_);
        const double q = radius * radius - cross(c, v_) * cross(c, v_);
        if (b <= 0 || q < 0) return std::numeric_limits<double>::infinity();
        return std::max(0.0, b - std::sqrt(q));
    }

    const PoolTable* pool_;
    double radius_;
    Vec2 r_;
    Vec2 v_;
    bool escaped_ = false;
};

/// Whether a ball at p is in front of every facing nearby, not behind the rubber.
bool in_a_mouth(const PoolTable& pool, Vec2 p, double radius) {
    return std::all_of(pool.lines().begin(), pool.lines().end(), [&](const CushionLine& line) {
        if (line.rail < kFirstJaw || norm(line.to - p) > 0.12) return true;
        return dot(line.from - p, line.normal) > radius - 1e-9;
    });
}

TEST(PoolTable, NoBallLeavesTheTableButIntoAHole) {
    testing::Random random(7);
    int drops = 0;
    int jaw_contacts = 0;
    for (int i = 0; i < 4000; ++i) {
        const Table table = i % 2 == 0 ? kTable : Table{.length = 0.5, .width = 0.25};
        const PoolTable pool(table);
        const double radius = random.uniform(i % 10 == 0 ? 0.005 : 0.0254, 0.03);
        const Vec2 edge = inset(table, radius);
        Path path(pool, radius, {random.uniform(-edge.x, edge.x), random.uniform(-edge.y, edge.y)},
                  random.direction());
        bool rolling = true;
        for (int bounce = 0; bounce < 300 && rolling; ++bounce) {
            rolling = path.advance();
            ASSERT_FALSE(path.escaped()) << i << ' ' << path.place().x << ' ' << path.place().y;
            ASSERT_GT(distance_to_rubber(pool, path.place()), radius - 1e-9) << i;
            if (std::abs(path.place().x) > edge.x + 1e-9 ||
                std::abs(path.place().y) > edge.y + 1e-9)
                ++jaw_contacts;
        }
        if (rolling) continue;
        ++drops;
        ASSERT_TRUE(in_a_mouth(pool, path.place(), radius)) << i;
    }
    RecordProperty("drops", drops);
    RecordProperty("jaw_contacts", jaw_contacts);
    EXPECT_GT(drops, 3000);
    EXPECT_GT(jaw_contacts, 300);
}

TEST(PoolTable, ABallCanRattleBetweenTheJawsAndComeOut) {
    testing::Random random(8);
    int rattles = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec2 start{random.uniform(0.8, 1.2), random.uniform(0.1, 0.6)};
        const Vec2 lip_n = lip(Rail::kNorthEastJawN, Rail::kNorth);
        Path path(kPool, kRadius, start, lip_n + random.uniform(0, 0.06) * Vec2{1, -1} - start);
        int inside = 0;
        while (path.advance() && path.place().x + path.place().y > lip_n.x + lip_n.y)
            ++inside;
        if (inside > 1 && path.place().x + path.place().y < lip_n.x + lip_n.y) ++rattles;
    }
    EXPECT_GT(rattles, 0);
}

}  // namespace
}  // namespace poolhall
