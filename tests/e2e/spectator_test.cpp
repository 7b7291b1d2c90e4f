#include "shared/physics/simulate.hpp"
#include "tests/e2e/server_process.hpp"
#include "tests/e2e/table.hpp"

#include <algorithm>
#include <gtest/gtest.h>

// What those who only watch see of a shot, and when.
namespace poolhall::e2e {
namespace {

using namespace protocol;

class Spectator : public testing::Test {
  protected:
    TemporaryFolder data;
    ServerProcess server{data.path()};
    Duel duel{server.port()};
};

TEST_F(Spectator, WhoComesInMidShotSeesItFromThereToItsEnd) {
    const PlayedShot outcome = find_shot(duel.game, Verdict::kTurnPasses);
    duel.player(duel.game.turn).send(command_of(outcome));
    duel.ann.await<Frame>([](const Frame& frame) { return frame.tick >= 10; });

    ProtocolClient late(server.port(), Encoding::kJson);
    const TableState table = late.enter(WatchMatch{duel.ann_joined.table.code, "Wanda"}).table;
    EXPECT_EQ(table.phase, Phase::kPlaying);
    EXPECT_EQ(table.state, duel.game);
    ASSERT_TRUE(table.live);
    EXPECT_EQ(table.live->shot, 1U);
    ASSERT_GE(table.live->tick, 10U);
    ASSERT_EQ(table.live->balls.size(), 2U);
    for (std::size_t ball = 0; ball < 2; ++ball) {
        const Vec2 exact = xy(outcome.trace.sample(table.live->tick, ball));
        EXPECT_NEAR(table.live->balls[ball].x, exact.x, 1e-5);
        EXPECT_NEAR(table.live->balls[ball].y, exact.y, 1e-5);
    }

    const Frame next = late.await<Frame>();
    EXPECT_GT(next.tick, table.live->tick);
    const ShotEnded ended = late.await<ShotEnded>();
    EXPECT_EQ(ended.hash, outcome.trace.hash);
    expect_table_after(ended.table, outcome);
}

TEST_F(Spectator, SeesFramesAtThirtyHertz) {
    const PlayedShot outcome = find_shot(duel.game, Verdict::kTurnPasses);
    duel.player(duel.game.turn).send(command_of(outcome));
    const ShotHeard heard = duel.bob.hear_shot();

    std::vector<double> intervals;  // s a tick
    for (std::size_t i = 1; i < heard.frames.size(); ++i) {
        const std::chrono::duration<double> gap = heard.frame_times[i] - heard.frame_times[i - 1];
        intervals.push_back(gap.count() / (heard.frames[i].tick - heard.frames[i - 1].tick));
    }
    ASSERT_GT(intervals.size(), 20U);
    const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
    std::nth_element(intervals.begin(), middle, intervals.end());
    // Wide enough for a machine under load: a loop that is late catches up.
    EXPECT_GT(*middle, 0.015);
    EXPECT_LT(*middle, 0.070);
}

TEST_F(Spectator, IsCountedAndMayLeave) {
    ProtocolClient watcher(server.port(), Encoding::kCbor);
    watcher.enter(WatchMatch{duel.ann_joined.table.code, "Wanda"});
    duel.ann.await_table([](const TableState& table) { return table.spectators == 1; });
    watcher.request(Leave{});
    duel.ann.await_table([](const TableState& table) { return table.spectators == 0; });
}

TEST_F(Spectator, CannotPlay) {
    ProtocolClient watcher(server.port(), Encoding::kJson);
    watcher.enter(WatchMatch{duel.ann_joined.table.code, "Wanda"});
    EXPECT_EQ(watcher.refused(shot_by(duel.game.turn, {1, 0})).code, RejectCode::kNotYourSeat);
    EXPECT_EQ(watcher.refused(rematch_by(Seat{0})).code, RejectCode::kNotYourSeat);
    EXPECT_EQ(watcher.refused(TakeSeat{Seat{0}}).code, RejectCode::kSeatTaken);
}

}  // namespace
}  // namespace poolhall::e2e
