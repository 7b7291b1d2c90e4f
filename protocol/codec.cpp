#include "protocol/codec.hpp"

#include "protocol/limits.hpp"
#include "protocol/tree.hpp"
#include "protocol/wire/message_tree.hpp"

#include <nlohmann/json.hpp>

namespace poolhall::protocol {
namespace {

using wire::Json;

template <class... Bodies>
void write_body(Json& tree, const std::variant<Bodies...>& body, Encoding encoding) {
    std::visit([&](const auto& alternative) { wire::write_fields(tree, alternative, encoding); },
               body);
}

template <class... Bodies>
std::string_view type_of(const std::variant<Bodies...>& body) {
    return std::visit([](const auto& alternative) { return alternative.kType; }, body);
}

}  // namespace

Result<ServerMessage, DecodeError> decode_server(std::string_view bytes, Encoding encoding) {
    const auto tree = wire::read_message_tree(bytes, encoding, kMaxServerMessageBytes);
    if (!tree) return tree.error();
    wire::Reading reading{wire::UnknownFields::kSkip, wire::HexFloats::kRefuse};
    const wire::Cursor root(*tree, reading);
    ServerMessage message;
    if (wire::read_body(root, message, {"type"})) return message;
    return DecodeError{0, reading.error->code, wire::sentence(*reading.error)};
}

std::string encode(const ClientMessage& message, Encoding encoding) {
    Json tree{{"type", type_of(message.body)}, {"seq", message.seq}};
    write_body(tree, message.body, encoding);
    return write_tree(tree, encoding);
}

std::string encode(const ServerMessage& message, Encoding encoding) {
    Json tree{{"type", type_of(message)}};
    write_body(tree, message, encoding);
    return write_tree(tree, encoding);
}

}  // namespace poolhall::protocol
