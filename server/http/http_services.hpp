#pragma once

#include "server/http/routes.hpp"
#include "server/net/admission.hpp"
#include "server/session/session_services.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace boost::asio {
class thread_pool;
}

namespace poolhall::server {

/// What connections need of the server before they are sessions; outlives them.
struct HttpServices {
    Admission& admission;
    SessionServices& sessions;
    RouteServices routes;
    boost::asio::thread_pool& readers;  ///< for routes that block
    std::vector<std::string> allowed_origins;
    std::int64_t max_sessions = 0;
};

}  // namespace poolhall::server
