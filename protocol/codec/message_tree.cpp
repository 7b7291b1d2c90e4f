#include "protocol/codec/message_tree.hpp"

#include "protocol/tree.hpp"

#include <nlohmann/json.hpp>
#include <utility>

namespace poolhall::protocol::wire {

/// "field /direction/0 must be a number".
std::string sentence(const ReadError& error) {
    return (error.pointer.empty() ? "the message" : "field " + error.pointer) + " " + error.reason;
}

Result<Json, DecodeError> read_message_tree(std::string_view bytes, Encoding encoding,
                                            std::size_t max_bytes) {
    if (bytes.size() > max_bytes) {
        return DecodeError{0, RejectCode::kMalformed,
                           "the message is longer than " + std::to_string(max_bytes) + " bytes"};
    }
    auto tree = parse_tree(bytes, encoding);
    if (!tree)
        return DecodeError{0, RejectCode::kMalformed, "the message has " + tree.error().reason};
    if (!tree->is_object())
        return DecodeError{0, RejectCode::kMalformed, "the message must be an object"};
    return *std::move(tree);
}

}  // namespace poolhall::protocol::wire
