#pragma once

#include "protocol/wire/codecs.hpp"
#include "shared/fields.hpp"

#include <tuple>
#include <type_traits>
#include <utility>

// The fields of structs that list them in shared: names and order are the list's, codecs follow
// from the types of the members. Ranges are left to check(), so that a scene is judged alike
// wherever it came from.
namespace poolhall::protocol::wire {

namespace listed {

template <class T>
constexpr auto codec_of(std::type_identity<T> /*member*/, const auto& /*field*/) {
    return DefaultCodec<T>{};
}

constexpr auto codec_of(std::type_identity<double> /*member*/, const auto& /*field*/) {
    return SceneNumber{};
}

constexpr auto codec_of(std::type_identity<Vec2> /*member*/, const auto& /*field*/) {
    return SceneVector2{};
}

constexpr auto codec_of(std::type_identity<Vec3> /*member*/, const auto& field) {
    return Vector3{field.least_components};
}

constexpr auto codec_of(std::type_identity<std::string> /*member*/, const auto& field) {
    return Text{static_cast<std::size_t>(field.bounds.low),
                static_cast<std::size_t>(field.bounds.high)};
}

template <class T>
constexpr auto codec_of(std::type_identity<std::optional<T>> /*member*/, const auto& field) {
    return codec_of(std::type_identity<T>{}, field);
}

template <class T>
constexpr auto codec_of(std::type_identity<std::vector<T>> /*member*/, const auto& field) {
    using Codec = decltype(codec_of(std::type_identity<T>{}, field));
    return List<Codec>{{}, static_cast<std::size_t>(field.bounds.high)};
}

template <class T, class Access>
constexpr auto wire_field(const fields::Field<Access>& listed) {
    const auto codec = codec_of(std::type_identity<fields::Member<T, Access>>{}, listed);
    const auto presence = listed.may_be_left_out ? Presence::kDefaulted : Presence::kRequired;
    return Field<Access, std::remove_const_t<decltype(codec)>>{listed.name, listed.access, codec,
                                                               presence};
}

template <class T, std::size_t kFrom, std::size_t... kIndex>
constexpr auto part(std::index_sequence<kIndex...> /*indices*/) {
    constexpr auto kList = T::field_list();
    return std::tuple{wire_field<T>(std::get<kFrom + kIndex>(kList))...};
}

template <class T>
inline constexpr std::size_t kSize = std::tuple_size_v<decltype(T::field_list())>;

}  // namespace listed

/// The first fields of the list.
template <HasFieldList T, std::size_t kCount>
constexpr auto head_of() {
    return listed::part<T, 0>(std::make_index_sequence<kCount>{});
}

/// All fields of the list but the first.
template <HasFieldList T, std::size_t kFrom>
constexpr auto tail_of() {
    return listed::part<T, kFrom>(std::make_index_sequence<listed::kSize<T> - kFrom>{});
}

/// The fields of a member as fields of the object that has it.
template <class Owner, class T, class... F>
constexpr auto within(T Owner::*member, const std::tuple<F...>& its_fields) {
    const auto lift = [member](const auto& inner) {
        return field(
            inner.name, [ member, access = inner.access ](auto& owner) -> auto& {
                return std::invoke(access, owner.*member);
            },
            inner.codec);
    };
    return std::apply(
        [&](const auto&... inner) {
            return std::tuple{inner.presence == Presence::kDefaulted ? lift(inner).or_default()
                                                                     : lift(inner)...};
        },
        its_fields);
}

template <HasFieldList T>
inline constexpr auto kFields<T> = tail_of<T, 0>();

}  // namespace poolhall::protocol::wire
