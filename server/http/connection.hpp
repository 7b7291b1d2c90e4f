#pragma once

#include "server/http/connection_services.hpp"
#include "server/net/asio.hpp"

namespace poolhall::server {

/// Serves one connection, on the shard's loop: HTTP requests until one of them asks for a
/// WebSocket.
[[nodiscard]] net::Async<void> serve_connection(net::Socket socket, Shard& shard,
                                                ConnectionServices& services);

}  // namespace poolhall::server
