#pragma once

#include "server/delivery/outlet.hpp"

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

    /// To one connection, which need not follow the match.
    static void send(const Member& member, const protocol::ServerMessage& message);

  private:
    static constexpr std::size_t kEncodings = 2;
    static constexpr std::size_t kStreams = 2;

    struct Follower {
        Member member;
        protocol::Stream stream = protocol::Stream::kStates;
    };

    /// The outlets of one loop; used on its thread.
    struct Audience;

    struct Branch {
        Loop* loop = nullptr;
        std::shared_ptr<Audience> audience;
        std::size_t followers = 0;
    };

    struct Broadcast;
    void broadcast(const protocol::ServerMessage& message,
                   const std::array<bool, kStreams>& streams);
    Branch& branch_of(Loop* loop);

    std::map<MemberId, Follower> followers_;
    std::vector<Branch> branches_;
    std::array<std::array<std::size_t, kEncodings>, kStreams> counts_{};
};

}  // namespace poolhall::server
