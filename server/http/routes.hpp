#pragma once

#include "server/http/reply.hpp"
#include "server/room/lobby.hpp"

#include <functional>
#include <string_view>

namespace poolhall::server {

struct RouteServices {
    const Lobby& lobby;
    const ReplayStore& store;
    const Counters& counters;
    std::function<bool()> ready;  ///< takes new matches
};

struct Route {
    bool blocking = false;  ///< takes long, or reads the disk: not for an event loop
    std::function<HttpReply()> answer;
};

/// Whether the target is one of those that tell how the server does.
[[nodiscard]] bool is_health_check(std::string_view target);

/// What a request is answered with; errors are routes too. `target` is the request's, with its
/// query.
[[nodiscard]] Route find_route(const RouteServices& services, std::string_view method,
                               std::string_view target);

}  // namespace poolhall::server
