#pragma once

#include "protocol/codec/codec.hpp"
#include "protocol/wire/message_fields.hpp"

#include <cstddef>
#include <string>
#include <string_view>

// What reading a message has in common, whoever sent it.
namespace poolhall::protocol::wire {

/// The tree of a message of at most `max_bytes`.
[[nodiscard]] Result<Json, DecodeError> read_message_tree(std::string_view bytes, Encoding encoding,
                                                          std::size_t max_bytes);

/// "field /direction/0 must be a number".
[[nodiscard]] std::string sentence(const ReadError& error);

}  // namespace poolhall::protocol::wire
