#pragma once

#include "protocol/encoding.hpp"
#include "protocol/wire/cursor.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <tuple>
#include <type_traits>

// Objects are described by a list of their fields (kFields), and that list is all there is: it
// drives writing, reading, the refusal of unknown fields and the tests of the schemas.
//
// A codec is a small value with two members, of which the first checks everything and refuses
// through the cursor:
//
//     bool read(const Cursor& cursor, T& value) const;
//     Json write(const T& value, Encoding encoding) const;
namespace poolhall::protocol::wire {

enum class Presence : std::uint8_t {
    kRequired,
    kDefaulted,  ///< may be left out: the member keeps its initial value
};

template <class T>
inline constexpr bool kIsOptional = false;
template <class T>
inline constexpr bool kIsOptional<std::optional<T>> = true;

/// One field: its name on the wire, the way from the object to the member, and the member's codec.
/// A std::optional member's field is absent when the member is empty, and the codec is that of its
/// value.
template <class Access, class Codec>
struct Field {
    std::string_view name;
    Access access;
    Codec codec;
    Presence presence = Presence::kRequired;

    [[nodiscard]] constexpr Field or_default() const {
        return {name, access, codec, Presence::kDefaulted};
    }
};

/// The codec of a type whose form needs no parameter; codecs.hpp has the specialisations.
template <class T>
struct DefaultCodec;

/// A field with the default codec of the member's type.
template <class Owner, class T>
constexpr auto field(std::string_view name, T Owner::*member) {
    return Field<T Owner::*, DefaultCodec<T>>{name, member, {}};
}

/// A field with a codec of its own. `access` is a pointer to a member, or a function from the
/// object to it.
template <class Access, class Codec>
constexpr auto field(std::string_view name, Access access, Codec codec) {
    return Field<Access, Codec>{name, access, codec};
}

/// The std::tuple of T's fields; specialised for each object of the protocol.
template <class T>
inline constexpr std::nullptr_t kFields = nullptr;

template <class T>
concept HasFields = !std::is_same_v<std::remove_const_t<decltype(kFields<T>)>, std::nullptr_t>;

template <class T, class F>
bool read_field(const Cursor& object, const F& spec, T& value) {
    auto& member = std::invoke(spec.access, value);
    using Member = std::remove_cvref_t<decltype(member)>;
    const Json* found = object.find(spec.name);
    if (found == nullptr) {
        const bool optional = kIsOptional<Member> || spec.presence == Presence::kDefaulted;
        return optional || object.refuse_missing(spec.name);
    }
    const Cursor cursor = object.field(spec.name, *found);
    if constexpr (kIsOptional<Member>) {
        return spec.codec.read(cursor, member.emplace());
    } else {
        return spec.codec.read(cursor, member);
    }
}

template <class T>
bool is_field(std::string_view key) {
    return std::apply([&](const auto&... fields) { return ((fields.name == key) || ...); },
                      kFields<T>);
}

/// Reads T's fields from an object. `others` are keys that the caller reads itself.
template <HasFields T>
bool read_fields(const Cursor& cursor, T& value,
                 std::initializer_list<std::string_view> others = {}) {
    if (!cursor.json().is_object()) return cursor.refuse("must be an object");
    const auto read_all = [&](const auto&... fields) {
        return (read_field(cursor, fields, value) && ...);
    };
    if (!std::apply(read_all, kFields<T>)) return false;
    if (cursor.skips_unknown_fields()) return true;
    for (const auto& item : cursor.json().items()) {
        const bool other = std::find(others.begin(), others.end(), item.key()) != others.end();
        if (!other && !is_field<T>(item.key())) return cursor.refuse_unknown(item.key());
    }
    return true;
}

template <class T, class F>
void write_field(Json& object, const F& spec, const T& value, Encoding encoding) {
    const auto& member = std::invoke(spec.access, value);
    if constexpr (kIsOptional<std::remove_cvref_t<decltype(member)>>) {
        if (member) object[spec.name] = spec.codec.write(*member, encoding);
    } else {
        object[spec.name] = spec.codec.write(member, encoding);
    }
}

/// Adds T's fields to an object.
template <HasFields T>
void write_fields(Json& object, const T& value, Encoding encoding) {
    std::apply([&](const auto&... fields) { (write_field(object, fields, value, encoding), ...); },
               kFields<T>);
}

}  // namespace poolhall::protocol::wire
