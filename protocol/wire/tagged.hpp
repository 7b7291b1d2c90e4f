#pragma once

#include "protocol/wire/codecs.hpp"

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

// Variants as objects whose "type" says which alternative they are: its kType. An alternative that
// is itself a variant stands for all of its own.
namespace poolhall::protocol::wire {

template <class T>
inline constexpr bool kIsVariant = false;
template <class... Alternatives>
inline constexpr bool kIsVariant<std::variant<Alternatives...>> = true;

/// Reads the alternative of that type; nothing if the variant has none of it, else whether it was
/// good.
template <class... Alternatives>
std::optional<bool> read_alternative(const Cursor& cursor, std::string_view type,
                                     std::variant<Alternatives...>& value,
                                     std::initializer_list<std::string_view> others) {
    std::optional<bool> read;
    const auto try_one = [&]<class T>(std::type_identity<T>) {
        if constexpr (kIsVariant<T>) {
            T inner;
            read = read_alternative(cursor, type, inner, others);
            if (read) value = std::move(inner);
        } else if (type == T::kType) {
            read = read_fields(cursor, value.template emplace<T>(), others);
        }
        return read.has_value();
    };
    static_cast<void>((try_one(std::type_identity<Alternatives>{}) || ...));
    return read;
}

/// Reads the variant. `others` are keys that the caller reads itself, "type" among them.
template <class... Alternatives>
bool read_tagged(const Cursor& cursor, std::variant<Alternatives...>& value,
                 std::initializer_list<std::string_view> others) {
    const Json* type = cursor.find("type");
    if (type == nullptr) return cursor.refuse_missing("type");
    if (!expect_text(cursor.field("type", *type))) return false;
    const auto read =
        read_alternative(cursor, type->template get_ref<const std::string&>(), value, others);
    return read ? *read
                : cursor.refuse_at("/type", "is none that is known here", RejectCode::kUnknownType);
}

/// Calls visitor with the alternative, however deep it lies.
template <class Visitor, class... Alternatives>
decltype(auto) visit_leaf(const Visitor& visitor, const std::variant<Alternatives...>& value) {
    return std::visit(
        [&]<class T>(const T& alternative) -> decltype(auto) {
            if constexpr (kIsVariant<T>)
                return visit_leaf(visitor, alternative);
            else
                return visitor(alternative);
        },
        value);
}

/// The kType of the alternative.
template <class... Alternatives>
std::string_view type_of(const std::variant<Alternatives...>& value) {
    return visit_leaf([](const auto& alternative) { return alternative.kType; }, value);
}

/// Adds the fields of the alternative to an object.
template <class... Alternatives>
void write_alternative(Json& object, const std::variant<Alternatives...>& value,
                       Encoding encoding) {
    visit_leaf([&](const auto& alternative) { write_fields(object, alternative, encoding); },
               value);
}

/// The codec of a variant that is an object of its own.
struct Tagged {
    template <class... Alternatives>
    [[nodiscard]] bool read(const Cursor& cursor, std::variant<Alternatives...>& value) const {
        if (!cursor.json().is_object()) return cursor.refuse("must be an object");
        return read_tagged(cursor, value, {"type"});
    }

    template <class... Alternatives>
    [[nodiscard]] Json write(const std::variant<Alternatives...>& value, Encoding encoding) const {
        Json object{{"type", type_of(value)}};
        write_alternative(object, value, encoding);
        return object;
    }
};

}  // namespace poolhall::protocol::wire
