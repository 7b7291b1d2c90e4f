#include "protocol/codec.hpp"

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

/// Reads the alternative of the variant whose kType is the tree's "type".
template <class... Bodies>
bool read_body(const Cursor& cursor, std::variant<Bodies...>& body,
               std::initializer_list<std::string_view> others) {
    const Json* type = cursor.find("type");
    if (type == nullptr) return cursor.refuse_missing("type");
    const Cursor at_type = cursor.field("type", *type);
    if (!wire::expect_text(at_type)) return false;
    bool read = false;
    const auto try_one = [&]<class Body>(std::in_place_type_t<Body> alternative) {
        if (*type != Body::kType) return false;
        read = wire::read_fields(cursor, body.template emplace<Body>(), others);
        return static_cast<void>(alternative), true;
    };
    const bool known = (try_one(std::in_place_type<Bodies>) || ...);
    return known ? read
                 : cursor.refuse_at("/type", "is no message that is known here",
                                    RejectCode::kUnknownType);
}

template <class... Bodies>
void write_body(Json& tree, const std::variant<Bodies...>& body, Encoding encoding) {
    std::visit([&](const auto& alternative) { wire::write_fields(tree, alternative, encoding); },
               body);
}

template <class... Bodies>
std::string_view type_of(const std::variant<Bodies...>& body) {
    return std::visit([](const auto& alternative) { return alternative.kType; }, body);
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
    if (read_seq(root, message.seq) && read_body(root, message.body, {"type", "seq"}))
        return message;
    return DecodeError{message.seq, reading.error->code, sentence(*reading.error)};
}

Result<ServerMessage, DecodeError> decode_server(std::string_view bytes, Encoding encoding) {
    const auto tree = read_tree(bytes, encoding, kMaxServerMessageBytes);
    if (!tree) return tree.error();
    Reading reading{wire::UnknownFields::kSkip, wire::HexFloats::kRefuse, {}};
    const Cursor root(*tree, reading);
    ServerMessage message;
    if (read_body(root, message, {"type"})) return message;
    return DecodeError{0, reading.error->code, sentence(*reading.error)};
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
