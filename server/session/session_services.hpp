#pragma once

#include "server/base/counters.hpp"
#include "server/delivery/shards.hpp"
#include "server/room/lobby.hpp"

#include <atomic>
#include <cstdint>

namespace poolhall::server {

/// What sessions need of the server; outlives them.
struct SessionServices {
    Lobby& lobby;
    Shards& shards;
    Counters& counters;
    std::atomic<std::uint64_t> last_member{0};
};

}  // namespace poolhall::server
