#include "server/match/playout.hpp"

#include "shared/game/end_game.hpp"
#include "shared/physics/simulate.hpp"

#include <gtest/gtest.h>

namespace poolhall::server {
namespace {

using protocol::Frame;

Playout playout() {
    const GameState state = kEndGameRules.new_game(Seat{0});
    return {1, kEndGameRules.play(state, {{1, 0.01}})};
}

std::vector<double> times(const std::vector<ShotEvent>& events) {
    std::vector<double> times;
    for (const ShotEvent& event : events)
        times.push_back(event.t);
    return times;
}

TEST(Playout, EveryEventFallsInTheFrameOfItsTick) {
    Playout playout = server::playout();
    std::vector<ShotEvent> seen;
    for (std::uint32_t tick = 1; tick <= playout.last_tick(); ++tick) {
        const Frame frame = playout.advance(tick);
        for (const ShotEvent& event : frame.events)
            EXPECT_LE(event.t, tick / kPlayoutHz);
        seen.insert(seen.end(), frame.events.begin(), frame.events.end());
    }
    EXPECT_TRUE(playout.finished());
    EXPECT_EQ(times(seen), times(playout.outcome().trace.events));
}

TEST(Playout, FrameHasOnlyTheBallsThatMoved) {
    Playout playout = server::playout();
    const Frame first = playout.advance(1);
    ASSERT_EQ(first.balls.size(), 1U) << "the 8-ball has not been hit yet";
    EXPECT_EQ(first.balls.front().r,
              xy(playout.outcome().trace.sample(1, first.balls.front().ball.value)));
}

TEST(Playout, SkippedTicksLoseNoEvent) {
    Playout playout = server::playout();
    const Frame all = playout.advance(playout.last_tick());
    EXPECT_EQ(all.events.size(), playout.outcome().trace.events.size());
}

TEST(Playout, MergedFramesEqualASkippedTick) {
    Playout whole = playout();
    Playout split = playout();
    const std::uint32_t half = whole.last_tick() / 2;
    const Frame expected = whole.advance(half + 5);
    const Frame early = split.advance(half);
    const Frame merged = merge(early, split.advance(half + 5));
    EXPECT_EQ(merged.tick, expected.tick);
    EXPECT_EQ(times(merged.events), times(expected.events));
    EXPECT_EQ(merged.balls.size(), expected.balls.size());
}

TEST(Playout, LateComerSeesWhereTheBallsAre) {
    Playout playout = server::playout();
    (void)playout.advance(7);
    const protocol::LiveShot live = playout.live();
    EXPECT_EQ(live.tick, 7U);
    ASSERT_EQ(live.balls.size(), 2U);
    EXPECT_EQ(live.balls[0], xy(playout.outcome().trace.sample(7, 0)));
}

}  // namespace
}  // namespace poolhall::server
