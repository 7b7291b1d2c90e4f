#pragma once

#include "server/net/asio.hpp"
#include "server/session/accepted_handshake.hpp"
#include "server/session/connection_services.hpp"

#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>

namespace poolhall::server {

using HttpRequest = boost::beast::http::request<boost::beast::http::string_body>;

/// Completes the WebSocket handshake that `judge` accepted and serves the session until it ends.
/// Thin: it decodes, checks rate and sequence, and hands commands on; what comes back waits in its
/// Outbox.
[[nodiscard]] net::Async<void> run_session(net::Socket socket, HttpRequest upgrade,
                                           AcceptedHandshake handshake, Shard& shard,
                                           ConnectionServices& services);

}  // namespace poolhall::server
