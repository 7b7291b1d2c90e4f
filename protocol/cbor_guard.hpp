#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace poolhall::protocol {

/// What makes the bytes something other than one CBOR item of the kinds that messages are made of
/// (RFC 8949 with definite lengths: integers, floats, false, true, null, text, arrays, maps with
/// text keys), nested at most kMaxNesting deep; nothing if they are such an item. Uses no recursion
/// and no memory beyond a small fixed stack, so that it can look at hostile bytes before a
/// recursive parser does.
[[nodiscard]] std::optional<std::string> find_cbor_fault(std::string_view bytes);

}  // namespace poolhall::protocol
