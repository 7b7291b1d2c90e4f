#include "client/desktop/app/audible.hpp"

#include "shared/game/end_game.hpp"

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
