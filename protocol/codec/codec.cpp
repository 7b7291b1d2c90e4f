#include "protocol/codec/codec.hpp"

#include "protocol/codec/message_tree.hpp"
#include "protocol/limits.hpp"
#include "protocol/tree.hpp"

#include <nlohmann/json.hpp>

namespace poolhall::protocol {

using wire::Json;

Result<ServerMessage, DecodeError> decode_server(std::string_view bytes, Encoding encoding) {
    const auto tree = wire::read_message_tree(bytes, encoding, kMaxServerMessageBytes);
    if (!tree) return tree.error();
    wire::Reading reading{wire::UnknownFields::kSkip, wire::HexFloats::kRefuse};
    const wire::Cursor root(*tree, reading);
    ServerMessage message;
    if (wire::read_tagged(root, message, {"type"})) return message;
    return DecodeError{0, reading.error->code, wire::sentence(*reading.error)};
}

std::string encode(const ClientMessage& message, Encoding encoding) {
    Json tree{{"type", wire::type_of(message.body)}, {"seq", message.seq}};
    wire::write_alternative(tree, message.body, encoding);
    return write_tree(tree, encoding);
}

std::string encode(const ServerMessage& message, Encoding encoding) {
    Json tree{{"type", wire::type_of(message)}};
    wire::write_alternative(tree, message, encoding);
    return write_tree(tree, encoding);
}

}  // namespace poolhall::protocol
