#include "server/delivery/outbox.hpp"

#include <gtest/gtest.h>

namespace poolhall::server {
namespace {

using namespace protocol;
using std::chrono::seconds;

constexpr Outbox::Clock::time_point kNow{};

Parcel parcel(ServerMessage message) {
    return {std::make_shared<const ServerMessage>(std::move(message)),
            std::make_shared<const std::string>("x")};
}

Parcel frame(std::uint32_t shot, std::uint32_t tick, std::uint16_t ball = 0) {
    ShotEvent event;
    event.t = tick;
    return parcel(Frame{shot, tick, {{BallIndex{ball}, {1.0 * tick, 0}}}, {event}});
}

template <class T>
std::vector<T> all_of(Outbox& outbox) {
    std::vector<T> found;
    while (const auto next = outbox.pop())
        if (const auto* wanted = std::get_if<T>(next->message.get())) found.push_back(*wanted);
    return found;
}

void fill(Outbox& outbox, std::uint32_t shot = 1) {
    for (std::uint32_t tick = 1; tick <= Outbox::kBacklog; ++tick)
        ASSERT_TRUE(outbox.push(frame(shot, tick), kNow));
}

TEST(Outbox, MessagesOfAQuickReaderAreLeftAlone) {
    Outbox outbox;
    fill(outbox);
    EXPECT_EQ(outbox.lag(kNow), Outbox::Clock::duration::zero());
    for (std::uint32_t tick = 1; tick <= Outbox::kBacklog; ++tick) {
        const auto next = outbox.pop();
        ASSERT_TRUE(next.has_value());
        EXPECT_NE(next->bytes, nullptr) << "the shared buffer is sent as it is";
        EXPECT_EQ(std::get<Frame>(*next->message).tick, tick);
    }
    EXPECT_FALSE(outbox.pop().has_value());
}

TEST(Outbox, SlowReaderSkipsToTheNewestFrameAndLosesNoEvent) {
    Outbox outbox;
    fill(outbox);
    constexpr std::uint32_t kLast = 1000;
    for (std::uint32_t tick = Outbox::kBacklog + 1; tick <= kLast; ++tick)
        ASSERT_TRUE(outbox.push(frame(1, tick, tick % 2 == 0 ? 0 : 1), kNow));
    EXPECT_EQ(outbox.size(), Outbox::kBacklog);
    const auto frames = all_of<Frame>(outbox);
    const Frame& newest = frames.back();
    EXPECT_EQ(newest.tick, kLast);
    std::size_t events = 0;
    for (const Frame& each : frames)
        events += each.events.size();
    EXPECT_EQ(events, kLast);
    ASSERT_EQ(newest.balls.size(), 2U) << "both balls moved since the frame before";
    for (const Frame::Ball& ball : newest.balls)
        EXPECT_GE(ball.r.x, kLast - 1);
}

TEST(Outbox, RepliesAreNeverDropped) {
    Outbox outbox;
    fill(outbox);
    ASSERT_TRUE(outbox.push(parcel(Accepted{7}), kNow));
    for (std::uint32_t tick = 20; tick < 60; ++tick)
        ASSERT_TRUE(outbox.push(frame(1, tick), kNow));
    ASSERT_TRUE(outbox.push(parcel(ShotStarted{}), kNow));
    const auto accepted = all_of<Accepted>(outbox);
    ASSERT_EQ(accepted.size(), 1U);
    EXPECT_EQ(accepted.front().seq, 7U);
}

TEST(Outbox, NewerAimOrTableReplacesTheOlder) {
    Outbox outbox;
    fill(outbox);
    for (std::uint32_t i = 1; i <= 50; ++i) {
        ASSERT_TRUE(outbox.push(parcel(AimChanged{Seat{0}, {1.0 * i, 0}, {}}), kNow));
        TableChanged table;
        table.table.spectators = i;
        ASSERT_TRUE(outbox.push(parcel(table), kNow));
    }
    EXPECT_EQ(outbox.size(), Outbox::kBacklog + 1);
    const auto tables = all_of<TableChanged>(outbox);
    ASSERT_EQ(tables.size(), 1U);
    EXPECT_EQ(tables.front().table.spectators, 50U);
}

TEST(Outbox, WholeShotsThatWaitShrinkToATable) {
    Outbox outbox;
    std::size_t most = 0;
    for (std::uint32_t shot = 1; shot <= 100; ++shot) {
        ASSERT_TRUE(outbox.push(parcel(ShotStarted{shot, Seat{0}, {}, 0, {}}), kNow));
        for (std::uint32_t tick = 1; tick <= 200; ++tick)
            ASSERT_TRUE(outbox.push(frame(shot, tick), kNow));
        ShotEnded ended;
        ended.shot = shot;
        ended.table.shot = shot;
        ASSERT_TRUE(outbox.push(parcel(ended), kNow));
        most = std::max(most, outbox.size());
    }
    EXPECT_LE(most, 3 * Outbox::kBacklog);
    std::vector<ServerMessage> rest;
    while (const auto next = outbox.pop())
        rest.push_back(*next->message);
    ASSERT_GE(rest.size(), 3U);
    ASSERT_TRUE(std::holds_alternative<TableChanged>(rest.front()));
    EXPECT_EQ(std::get<TableChanged>(rest.front()).table.shot, 99U);
    ASSERT_TRUE(std::holds_alternative<ShotEnded>(rest.back()));
    EXPECT_EQ(std::get<ShotEnded>(rest.back()).shot, 100U);
}

TEST(Outbox, SaysForHowLongTheReaderHasBeenBehind) {
    Outbox outbox;
    fill(outbox);
    ASSERT_TRUE(outbox.push(frame(1, 100), kNow));
    EXPECT_EQ(outbox.lag(kNow + seconds(3)), seconds(3));
    (void)outbox.pop();
    EXPECT_EQ(outbox.lag(kNow + seconds(4)), seconds(4)) << "one message read is not caught up";
    while (outbox.pop()) {
    }
    EXPECT_EQ(outbox.lag(kNow + seconds(5)), seconds(0));
}

TEST(Outbox, RefusesWhenNothingIsReadAtAll) {
    Outbox outbox;
    for (std::size_t i = 0; i < Outbox::kLimit; ++i)
        ASSERT_TRUE(outbox.push(parcel(Pong{1}), kNow));
    EXPECT_FALSE(outbox.push(parcel(Pong{1}), kNow));
}

}  // namespace
}  // namespace poolhall::server
