#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string_view>
#include <tuple>
#include <type_traits>

// Lists of fields. A struct that is read, written, hashed or checked lists its fields once, beside
// its members:
//
//     struct RollingSpec {
//         Real mu = 0.01;
//
//         static constexpr auto field_list() {
//             return std::tuple{fields::of("mu", &RollingSpec::mu, {0, 10}).or_default()};
//         }
//     };
//
// check() takes its bounds from there, the scene's hash its order, the codecs and the tests of the
// schemas its names.
namespace poolhall::fields {

/// From low to high, both included unless `above_low`: a number or each component of a vector, how
/// many bytes a text has, how many elements a list.
struct Bounds {
    double low = 0;
    double high = 0;
    bool above_low = false;
    bool any = false;  ///< no bounds: what may be is said elsewhere

    /// False for NaN.
    template <class Number>
    [[nodiscard]] constexpr bool hold(Number x) const {
        return any || ((above_low ? x > low : x >= low) && x <= high);
    }
};

inline constexpr Bounds kAny{0, 0, false, true};

/// 0 < x <= high.
constexpr Bounds positive(double high) {
    return {0, high, true};
}

/// One field. `access` is a pointer to the member, or a function from the object to it.
template <class Access>
struct Field {
    std::string_view name;  ///< in files and messages
    Access access;
    Bounds bounds = kAny;
    std::string_view unit{};               ///< SI; empty for a pure number
    bool may_be_left_out = false;          ///< in a file: the member keeps its initial value
    std::size_t least_components = 3;      ///< of a vector in space, in a file
    bool absence_enters_the_hash = false;  ///< of an optional member

    [[nodiscard]] constexpr Field in(std::string_view its_unit) const {
        Field field = *this;
        field.unit = its_unit;
        return field;
    }

    [[nodiscard]] constexpr Field or_default() const {
        Field field = *this;
        field.may_be_left_out = true;
        return field;
    }

    /// A vector in space whose third component may be left out.
    [[nodiscard]] constexpr Field or_in_plane() const {
        Field field = *this;
        field.least_components = 2;
        return field;
    }

    [[nodiscard]] constexpr Field hashed_if_absent() const {
        Field field = *this;
        field.absence_enters_the_hash = true;
        return field;
    }
};

template <class Access>
constexpr Field<Access> of(std::string_view name, Access access, Bounds bounds = kAny) {
    return {name, access, bounds};
}

/// The type of the field's member.
template <class T, class Access>
using Member = std::remove_cvref_t<std::invoke_result_t<Access, T&>>;

}  // namespace poolhall::fields

namespace poolhall {

template <class T>
concept HasFieldList = requires {
    T::field_list();
};

/// Calls visit(field, member) for each field of the object, in the list's order.
template <HasFieldList T, class Visit>
constexpr void for_each_field(T& object, Visit visit) {
    std::apply(
        [&](const auto&... field) { (visit(field, std::invoke(field.access, object)), ...); },
        std::remove_const_t<T>::field_list());
}

}  // namespace poolhall
