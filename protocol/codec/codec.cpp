#include "protocol/codec/codec.hpp"

#include "protocol/limits.hpp"
#include "protocol/tree.hpp"
#include "protocol/wire/message_fields.hpp"

#include <nlohmann/json.hpp>
#include <utility>

namespace poolhall::protocol {
namespace {

using wire::Cursor;
using wire::Json;
using wire::Reading;

/// "field /direction/0 must be a number".
std::string sentence(const wire::ReadError& error) {
    return (error.pointer.empty() ? "the message" : "field " + error.pointer) + " " + error.reason;
}

Result<Json, DecodeError> read_tree(std::string_view bytes, Encoding encoding,
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

bool read_seq(const Cursor& cursor, std::uint32_t& seq) {
    const Json* found = cursor.find("seq");
    return found == nullptr ? cursor.refuse_missing("seq")
                            : wire::kSeq.read(cursor.field("seq", *found), seq);
}

}  // namespace

Result<ClientMessage, DecodeError> decode_client(std::string_view bytes, Encoding encoding) {
    const auto tree = read_tree(bytes, encoding, kMaxClientMessageBytes);
    if (!tree) return tree.error();
    Reading reading{wire::UnknownFields::kRefuse, wire::HexFloats::kRefuse, {}};
    const Cursor root(*tree, reading);
    ClientMessage message;
    if (read_seq(root, message.seq) && wire::read_tagged(root, message.body, {"type", "seq"}))
        return message;
    return DecodeError{message.seq, reading.error->code, sentence(*reading.error)};
}

Result<ServerMessage, DecodeError> decode_server(std::string_view bytes, Encoding encoding) {
    const auto tree = read_tree(bytes, encoding, kMaxServerMessageBytes);
    if (!tree) return tree.error();
    Reading reading{wire::UnknownFields::kSkip, wire::HexFloats::kRefuse, {}};
    const Cursor root(*tree, reading);
    ServerMessage message;
    if (wire::read_tagged(root, message, {"type"})) return message;
    return DecodeError{0, reading.error->code, sentence(*reading.error)};
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
