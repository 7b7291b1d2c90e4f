#pragma once

#include "protocol/codec/codec.hpp"

namespace poolhall::protocol {

/// Reads what a client sent: strict. Every field is checked for type, finiteness, range and length;
/// a missing or an unknown field is an error; people's names come out as person_name() has them.
/// Never throws but std::bad_alloc, whatever the bytes are.
[[nodiscard]] Result<ClientMessage, DecodeError> decode_client(std::string_view bytes,
                                                               Encoding encoding);

}  // namespace poolhall::protocol
