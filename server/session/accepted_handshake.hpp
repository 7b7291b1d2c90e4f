#pragma once

#include "protocol/encoding.hpp"

#include <string_view>

namespace poolhall::server {

/// What was agreed on when a request became a WebSocket.
struct AcceptedHandshake {
    protocol::Encoding encoding = protocol::Encoding::kJson;
    std::string_view subprotocol;  ///< to be named in the answer; empty if none was asked for
};

}  // namespace poolhall::server
