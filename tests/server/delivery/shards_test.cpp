#include "server/delivery/shards.hpp"

#include "server/delivery/fan_out.hpp"
#include "tests/server/support/house.hpp"

#include <gtest/gtest.h>

namespace poolhall::server::test {
namespace {

using namespace protocol;

class ShardsTest : public testing::Test {
  protected:
    Member add(std::uint64_t id, ShardId shard, Encoding encoding = Encoding::kJson) {
        auto outlet = std::make_shared<FakeOutlet>();
        shards.at(shard).add({id}, outlet);
        outlets.push_back(std::move(outlet));
        return {{id}, shard, encoding};
    }

    std::size_t received(std::size_t outlet) {
        shards.run_ready();
        return outlets[outlet]->got.size();
    }

    Shards shards{2};
    std::vector<std::shared_ptr<FakeOutlet>> outlets;
};

TEST_F(ShardsTest, MessageReachesTheMemberOnItsOwnLoop) {
    add(1, {0});
    const Member second = add(2, {1});
    shards.send(second, Pong{5});
    EXPECT_EQ(received(0), 0U);
    ASSERT_EQ(received(1), 1U);
    EXPECT_EQ(outlets[1]->got[0], ServerMessage(Pong{5}));
}

TEST_F(ShardsTest, WhatIsSentToAConnectionThatIsGoneIsDropped) {
    const Member removed = add(1, {0});
    const Member destroyed = add(2, {0});
    shards.at({0}).remove(removed.id);
    const auto kept = std::exchange(outlets[0], nullptr);
    outlets[1].reset();
    shards.send(removed, Pong{1});
    shards.send(destroyed, Pong{2});
    shards.run_ready();
    EXPECT_TRUE(kept->got.empty());
}

TEST_F(ShardsTest, FanOutSendsEachFollowerWhatItsStreamHas) {
    FanOut followers(shards);
    followers.add(add(1, {0}), Stream::kStates);
    followers.add(add(2, {1}, Encoding::kCbor), Stream::kShots);
    const Member third = add(3, {1});
    followers.add(third, Stream::kStates);
    followers.send(Frame{}, Stream::kStates);
    followers.send(TableChanged{});
    EXPECT_EQ(received(0), 2U);
    EXPECT_EQ(received(1), 1U);
    EXPECT_EQ(received(2), 2U);
    followers.remove(third.id);
    followers.send(TableChanged{});
    EXPECT_EQ(received(1), 2U);
    EXPECT_EQ(received(2), 2U);
    EXPECT_EQ(followers.find(third.id), nullptr);
    EXPECT_EQ(followers.size(), 2U);
}

}  // namespace
}  // namespace poolhall::server::test
