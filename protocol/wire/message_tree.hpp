#pragma once

#include "protocol/codec.hpp"
#include "protocol/wire/message_fields.hpp"

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <variant>

// What reading a message has in common, whoever sent it.
namespace poolhall::protocol::wire {

/// The tree of a message of at most `max_bytes`.
[[nodiscard]] Result<Json, DecodeError> read_message_tree(std::string_view bytes, Encoding encoding,
                                                          std::size_t max_bytes);

/// "field /direction/0 must be a number".
[[nodiscard]] std::string sentence(const ReadError& error);

/// Reads the alternative of the variant whose kType is the tree's "type".
template <class... Bodies>
bool read_body(const Cursor& cursor, std::variant<Bodies...>& body,
               std::initializer_list<std::string_view> others) {
    const Json* type = cursor.find("type");
    if (type == nullptr) return cursor.refuse_missing("type");
    const Cursor at_type = cursor.field("type", *type);
    if (!expect_text(at_type)) return false;
    bool read = false;
    const auto try_one = [&]<class Body>(std::in_place_type_t<Body> alternative) {
        if (*type != Body::kType) return false;
        read = read_fields(cursor, body.template emplace<Body>(), others);
        return static_cast<void>(alternative), true;
    };
    const bool known = (try_one(std::in_place_type<Bodies>) || ...);
    return known ? read
                 : cursor.refuse_at("/type", "is no message that is known here",
                                    RejectCode::kUnknownType);
}

}  // namespace poolhall::protocol::wire
