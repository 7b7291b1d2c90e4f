#include "server/delivery/merge_frames.hpp"

#include <gtest/gtest.h>

namespace poolhall::server {
namespace {

using protocol::Frame;

constexpr BallIndex kCue{0};
constexpr BallIndex kEight{1};

Frame frame(std::uint32_t tick, std::vector<Frame::Ball> balls, std::vector<double> times) {
    Frame frame{1, tick, std::move(balls), {}};
    for (const double t : times)
        frame.events.emplace_back().t = t;
    return frame;
}

TEST(MergeFrames, EveryBallThatMovedIsWhereItIsNow) {
    const Frame merged =
        merge(frame(1, {{kCue, {1, 0}}, {kEight, {2, 0}}}, {}), frame(2, {{kCue, {1, 1}}}, {}));
    EXPECT_EQ(merged.tick, 2U);
    ASSERT_EQ(merged.balls.size(), 2U);
    EXPECT_EQ(merged.balls[0], (Frame::Ball{kCue, {1, 1}}));
    EXPECT_EQ(merged.balls[1], (Frame::Ball{kEight, {2, 0}}));
}

TEST(MergeFrames, EventsOfBothStayInOrder) {
    const Frame merged = merge(frame(1, {}, {0.1, 0.2}), frame(4, {}, {0.3}));
    ASSERT_EQ(merged.events.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_DOUBLE_EQ(merged.events[i].t, 0.1 * static_cast<double>(i + 1));
}

}  // namespace
}  // namespace poolhall::server
