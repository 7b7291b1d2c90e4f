#pragma once

#include "protocol/encoding.hpp"

#include <compare>
#include <cstdint>

namespace poolhall::server {

/// A connection that follows a match. Numbers are not used twice while the server runs.
struct MemberId {
    std::uint64_t value = 0;

    friend constexpr auto operator<=>(const MemberId&, const MemberId&) = default;
};

/// One of the loops that connections live on, by its place in Shards.
struct ShardId {
    std::uint32_t value = 0;

    friend constexpr auto operator<=>(const ShardId&, const ShardId&) = default;
};

/// The address of a connection, as matches know it: a value that may be kept and sent anywhere.
/// What is sent to a connection that is gone is dropped.
struct Member {
    MemberId id;
    ShardId shard;
    protocol::Encoding encoding = protocol::Encoding::kJson;
};

}  // namespace poolhall::server
