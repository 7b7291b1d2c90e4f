#pragma once

#include "server/net/asio.hpp"
#include "server/session/connection_services.hpp"

namespace poolhall::server {

/// Serves one connection, on the shard's loop: HTTP requests until one of them asks for a
/// WebSocket.
[[nodiscard]] net::Async<void> serve_connection(net::Socket socket, Shard& shard,
                                                ConnectionServices& services);

}  // namespace poolhall::server
