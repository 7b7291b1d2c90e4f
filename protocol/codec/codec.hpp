#pragma once

#include "protocol/encoding.hpp"
#include "protocol/messages.hpp"
#include "shared/result.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace poolhall::protocol {

/// Why bytes are no message. `seq` is the message's where it could be read, else 0.
struct DecodeError {
    std::uint32_t seq = 0;
    RejectCode code = RejectCode::kMalformed;
    std::string reason;  ///< one sentence that names the field
};

[[nodiscard]] std::string encode(const ClientMessage& message, Encoding encoding);

/// Reads what a server sent: unknown fields are skipped. Never throws.
[[nodiscard]] Result<ServerMessage, DecodeError> decode_server(std::string_view bytes,
                                                               Encoding encoding);
[[nodiscard]] std::string encode(const ServerMessage& message, Encoding encoding);

}  // namespace poolhall::protocol
