#include "protocol/intake/decode_client.hpp"

#include "protocol/codec/message_tree.hpp"
#include "protocol/intake/person_name.hpp"
#include "protocol/limits.hpp"

#include <nlohmann/json.hpp>
#include <utility>

namespace poolhall::protocol {
namespace {

using wire::Cursor;
using wire::Json;

bool read_seq(const Cursor& cursor, std::uint32_t& seq) {
    const Json* found = cursor.find("seq");
    return found == nullptr ? cursor.refuse_missing("seq")
                            : wire::kSeq.read(cursor.field("seq", *found), seq);
}

/// Brings a name into the form that is kept.
std::optional<std::string_view> enter_name(std::string& name) {
    auto entered = person_name(name);
    if (!entered) return entered.error().reason;
    name = *std::move(entered);
    return std::nullopt;
}

}  // namespace

Result<ClientMessage, DecodeError> decode_client(std::string_view bytes, Encoding encoding) {
    const auto tree = wire::read_message_tree(bytes, encoding, kMaxClientMessageBytes);
    if (!tree) return tree.error();
    wire::Reading reading{wire::UnknownFields::kRefuse, wire::HexFloats::kRefuse, enter_name};
    const Cursor root(*tree, reading);
    ClientMessage message;
    if (read_seq(root, message.seq) && wire::read_tagged(root, message.body, {"type", "seq"}))
        return message;
    return DecodeError{message.seq, reading.error->code, wire::sentence(*reading.error)};
}

}  // namespace poolhall::protocol
