#pragma once

#include "protocol/encoding.hpp"

#include <string_view>

namespace poolhall::server {

/// What a session has agreed on before it begins.
struct AcceptedHandshake {
    protocol::Encoding encoding = protocol::Encoding::kJson;
    std::string_view subprotocol;  ///< to be named in the answer; empty if none was asked for
};

}  // namespace poolhall::server
