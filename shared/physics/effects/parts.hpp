#pragma once

#include <tuple>
#include <type_traits>

namespace poolhall {

namespace parts_detail {

/// Of an effect whose parameters are the table's.
template <class Effect>
struct Nothing {
    friend constexpr bool operator==(const Nothing&, const Nothing&) = default;
};

template <class Effect>
struct PartOf : std::type_identity<Nothing<Effect>> {};

template <class Effect>
requires requires {
    typename Effect::Part;
}

struct PartOf<Effect> : std::type_identity<typename Effect::Part> {};

/// A tuple of the part's one field, or of none.
template <class Part>
constexpr auto fields_of_part() {
    if constexpr (requires { Part::part_field(); }) {
        return std::tuple{Part::part_field()};
    } else {
        return std::tuple{};
    }
}

}  // namespace parts_detail

/// The parameters of all effects of a tuple, each in a member that the effect's own header names.
template <class Effects>
struct PartsOf;

template <class... Effect>
struct PartsOf<std::tuple<Effect...>> : parts_detail::PartOf<Effect>::type... {
    /// Their fields, in the tuple's order.
    static constexpr auto part_fields() {
        return std::tuple_cat(
            parts_detail::fields_of_part<typename parts_detail::PartOf<Effect>::type>()...);
    }

    friend constexpr bool operator==(const PartsOf&, const PartsOf&) = default;
};

}  // namespace poolhall
