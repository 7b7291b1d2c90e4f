#pragma once

#include "server/http/reply.hpp"
#include "server/session/accepted_handshake.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace poolhall::server {

/// What a request to become a WebSocket says of itself; absent headers are empty.
struct Handshake {
    std::string_view target;
    std::string_view host;
    std::optional<std::string_view> origin;
    std::optional<std::string_view> subprotocols;  ///< Sec-WebSocket-Protocol, a list
};

/// Accepts or refuses it, before any of it becomes a session.
/// `allowed_origins`: origins ("https://example.org") of web pages that may connect; "*" allows
/// all. Empty: only pages of the server's own host. A client that is no browser sends no origin and
/// may always.
[[nodiscard]] std::variant<AcceptedHandshake, HttpReply> judge(
    const Handshake& handshake, const std::vector<std::string>& allowed_origins);

}  // namespace poolhall::server
