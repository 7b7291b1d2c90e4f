#include "client/desktop/app/audible.hpp"

#include "shared/game/end_game.hpp"
#include "shared/table/pool_table.hpp"

#include <gtest/gtest.h>

namespace poolhall::client {
namespace {

const Table kTable{2, 1, true, PocketModel::kNone};

ShotEvent collision(Vec2 v, Vec2 other_v) {
    ShotEvent event;
    event.kind = EventKind::kBallBall;
    event.ball_count = 2;
    event.before[1].r = {0.05, 0, 0};
    set_xy(event.before[0].v, v);
    set_xy(event.before[1].v, other_v);
    return event;
}

TEST(Audible, ClickIsAsLoudAsTheSpeedAlongTheLineOfCentres) {
    const double full = audible(collision({2, 0}, {0, 0}), kTable)->strength;
    EXPECT_NEAR(audible(collision({1, 0}, {0, 0}), kTable)->strength, full / 2, 1e-12);
    EXPECT_NEAR(audible(collision({1, 0}, {-1, 0}), kTable)->strength, full, 1e-12);
    EXPECT_NEAR(audible(collision({0, 2}, {0, 0}), kTable)->strength, 0, 1e-12);
    EXPECT_LE(audible(collision({99, 0}, {0, 0}), kTable)->strength, 1);
}

TEST(Audible, RailIsAsLoudAsTheSpeedTowardsIt) {
    ShotEvent event;
    event.kind = EventKind::kBallRail;
    event.rail = Rail::kNorth;
    set_xy(event.before[0].v, {2, 0.5});
    const double along = audible(event, kTable)->strength;
    event.rail = Rail::kEast;
    EXPECT_NEAR(audible(event, kTable)->strength, 4 * along, 1e-12);
}

/// A ball that meets a rail end of a pool table where its rubber faces along `normal`.
ShotEvent rattle(Rail jaw, Vec2 r, Vec2 v) {
    ShotEvent event;
    event.kind = EventKind::kBallRail;
    event.rail = jaw;
    set_xy(event.before[0].r, r);
    set_xy(event.before[0].v, v);
    return event;
}

TEST(Audible, JawIsAsLoudAsTheSpeedTowardsItsRubber) {
    constexpr double kRadius = 0.028575;
    const Table table{2.54, 1.27, true, PocketModel::kPool};
    const double full = audible(collision({2, 0}, {0, 0}), kTable)->strength;
    const PoolTable pool(table);
    for (const CushionArc& jaw : pool.arcs()) {
        const Vec2 middle = normalized(jaw.from + jaw.to);
        const Vec2 r = jaw.centre + (jaw.radius + kRadius) * middle;
        const Vec2 aside{middle.y, -middle.x};
        EXPECT_NEAR(audible(rattle(jaw.rail, r, -2 * middle), table)->strength, full, 1e-9)
            << name(jaw.rail);
        EXPECT_NEAR(audible(rattle(jaw.rail, r, 2 * aside), table)->strength, 0, 1e-9)
            << name(jaw.rail);
    }
    for (const CushionLine& facing : pool.lines().subspan(6)) {
        const Vec2 r = 0.5 * (facing.from + facing.to) - kRadius * facing.normal;
        EXPECT_NEAR(audible(rattle(facing.rail, r, 2 * facing.normal), table)->strength, full, 1e-9)
            << name(facing.rail);
    }
}

TEST(Audible, SoundComesFromWhereItHappens) {
    ShotEvent event;
    event.kind = EventKind::kBallPocket;
    event.after[0].r = {-1, 0, 0};
    EXPECT_EQ(audible(event, kTable)->pan, -1);
    event.after[0].r = {0.5, 0, 0};
    EXPECT_EQ(audible(event, kTable)->pan, 0.5);
}

TEST(Audible, ComingToRestIsSilent) {
    ShotEvent event;
    event.kind = EventKind::kRollToRest;
    EXPECT_FALSE(audible(event, kTable));
}

TEST(Audible, EndOfTheGameSoundsAsItIs) {
    EXPECT_EQ(audible(GameEnded{Tone::kLost}, kTable)->sound, Sound::kLost);
    EXPECT_EQ(audible(GameEnded{Tone::kWon}, kTable)->sound, Sound::kWon);
}

}  // namespace
}  // namespace poolhall::client
