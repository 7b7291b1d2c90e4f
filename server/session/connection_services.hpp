#pragma once

#include "server/net/loop.hpp"
#include "server/room/lobby.hpp"

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>

namespace poolhall::server {

/// A loop and the sessions that live on it. The map belongs to the loop's thread.
struct Shard {
    Loop loop;
    std::map<MemberId, std::weak_ptr<Outlet>> sessions;
};

/// What sessions need of the server; outlives them.
struct ConnectionServices {
    Lobby& lobby;
    Counters& counters;
    std::atomic<std::uint64_t> last_member{0};
};

}  // namespace poolhall::server
