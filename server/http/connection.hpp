#pragma once

#include "server/http/http_services.hpp"
#include "server/net/asio.hpp"

namespace poolhall::server {

/// Serves a new connection on the shard's loop, if there is a place for it: HTTP requests until one
/// of them asks for a WebSocket. Safe from any thread.
void serve_connection(net::Socket socket, Shard& shard, HttpServices& services);

}  // namespace poolhall::server
