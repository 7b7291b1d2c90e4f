#pragma once

#include "server/http/routes.hpp"
#include "server/net/loop.hpp"
#include "server/room/lobby.hpp"

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace boost::asio {
class thread_pool;
}

namespace poolhall::server {

/// A loop and the sessions that live on it. The map belongs to the loop's thread.
struct Shard {
    Loop loop;
    std::map<MemberId, std::weak_ptr<Outlet>> sessions;
};

/// What connections need of the server; outlives them.
struct ConnectionServices {
    Lobby& lobby;
    Counters& counters;
    RouteServices routes;
    boost::asio::thread_pool& readers;  ///< for routes that block
    std::vector<std::string> allowed_origins;
    std::int64_t max_sessions = 0;
    std::atomic<std::uint64_t> last_member{0};
};

}  // namespace poolhall::server
