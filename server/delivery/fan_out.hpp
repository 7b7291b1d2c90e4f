#pragma once

#include "protocol/messages.hpp"
#include "server/delivery/shards.hpp"

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <vector>

namespace poolhall::server {

/// The connections that follow one match. A message is encoded once for each encoding in use, and
/// the same immutable buffer goes to all; each loop with followers gets one post a message. Belongs
/// to the match's loop.
class FanOut {
  public:
    explicit FanOut(Shards& shards) : shards_(shards) {}

    void add(const Member& member, protocol::Stream stream);
    /// Nothing reaches the member any more, but for what was sent before.
    void remove(MemberId member);

    [[nodiscard]] bool empty() const { return followers_.empty(); }

    [[nodiscard]] std::size_t size() const { return followers_.size(); }

    [[nodiscard]] const Member* find(MemberId member) const;

    /// To everyone.
    void send(const protocol::ServerMessage& message);
    /// To those with this stream.
    void send(const protocol::ServerMessage& message, protocol::Stream stream);

  private:
    template <class T>
    using PerEncoding = std::array<T, kCount<protocol::Encoding>>;
    template <class T>
    using PerStream = std::array<T, kCount<protocol::Stream>>;
    using Streams = PerStream<bool>;

    struct Follower {
        Member member;
        protocol::Stream stream = protocol::Stream::kStates;
    };

    /// Who follows on one shard; used on its loop.
    struct Audience;

    struct Branch {
        ShardId shard;
        std::shared_ptr<Audience> audience;
        std::size_t followers = 0;
    };

    struct Broadcast;
    void send(const protocol::ServerMessage& message, const Streams& streams);
    [[nodiscard]] bool is_wanted(protocol::Encoding encoding, const Streams& streams) const;
    void post(const std::shared_ptr<const Broadcast>& broadcast);
    Branch& branch_of(ShardId shard);

    Shards& shards_;
    std::map<MemberId, Follower> followers_;
    std::vector<Branch> branches_;
    PerStream<PerEncoding<std::size_t>> counts_{};  ///< of followers
};

}  // namespace poolhall::server
