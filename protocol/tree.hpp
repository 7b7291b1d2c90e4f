#pragma once

#include "protocol/encoding.hpp"
#include "shared/result.hpp"

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace poolhall::protocol {

/// Why bytes are no tree.
struct TreeError {
    std::string reason;  ///< one sentence without a full stop
    /// Of a syntax error: how many bytes had been read, the wrong one included; more than there are
    /// if the value does not end.
    std::optional<std::size_t> position = {};
};

/// Reads one JSON or CBOR value and nothing after it. Refuses what could exhaust memory or stack or
/// be read in two ways, before a tree is built of it: nesting beyond kMaxNesting, the same key
/// twice in an object, text that is not UTF-8; in CBOR also tags, byte strings, indefinite lengths
/// and lengths beyond the input. A number that is beyond the largest double, or an integer that
/// neither 64 bits nor a double hold, is in the tree as a discarded value, which is of no type:
/// only who reads it knows what it is called. Never throws.
[[nodiscard]] Result<nlohmann::ordered_json, TreeError> parse_tree(std::string_view bytes,
                                                                   Encoding encoding);

/// The bytes of a tree. Never throws: text that is not UTF-8 is written with replacement
/// characters.
[[nodiscard]] std::string write_tree(const nlohmann::ordered_json& tree, Encoding encoding);

}  // namespace poolhall::protocol
