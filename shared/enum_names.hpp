#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <type_traits>

// Names of enumerators. An enumeration lists them beside its declaration, and that is all there is:
//
//     enum class Outcome : std::uint8_t { kRest, kTimeLimit };
//
//     constexpr auto enum_names(Outcome /*type*/) {
//         return names_of<Outcome>({{Outcome::kRest, "rest"}, {Outcome::kTimeLimit,
//         "time_limit"}});
//     }
//
// Then name(Outcome::kRest) is "rest", find<Outcome>("rest") is kRest, kCount<Outcome> is 2 and
// kValues<Outcome> has both. A list that leaves one out, or has them in another order than their
// values 0, 1, ..., does not compile.
namespace poolhall {

template <class E>
struct EnumName {
    E value{};
    std::string_view name;  ///< empty: nothing that a file or a message could say
};

// Only from an array can the compiler tell how many there are, as in std::to_array.
template <class E, std::size_t kSize>  // NOLINTNEXTLINE(modernize-avoid-c-arrays)
constexpr std::array<EnumName<E>, kSize> names_of(const EnumName<E> (&names)[kSize]) {
    return std::to_array(names);
}

template <class E>
concept NamedEnum = std::is_enum_v<E> && requires {
    enum_names(E{});
};

namespace enum_detail {

/// Whether the value is that of an enumerator: g++ and clang++ call another one "(E)7".
template <class E, E kValue>
constexpr bool is_enumerator() {
    const std::string_view text = __PRETTY_FUNCTION__;
    const std::size_t begin = text.find("kValue = ") + std::string_view("kValue = ").size();
    return text[begin] != '(';
}

template <class E>
constexpr bool counts_from_zero() {
    std::size_t i = 0;
    for (const EnumName<E>& entry : enum_names(E{})) {
        if (static_cast<std::size_t>(entry.value) != i++) return false;
    }
    return true;
}

}  // namespace enum_detail

/// How many enumerators there are.
template <NamedEnum E>
inline constexpr std::size_t kCount = [] {
    constexpr std::size_t kSize = enum_names(E{}).size();
    static_assert(enum_detail::counts_from_zero<E>(), "names stand in the order of their values");
    static_assert(!enum_detail::is_enumerator<E, static_cast<E>(kSize)>(), "one has no name");
    return kSize;
}();

/// All of them, in order.
template <NamedEnum E>
inline constexpr std::array<E, kCount<E>> kValues = [] {
    std::array<E, kCount<E>> all{};
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i] = static_cast<E>(i);
    return all;
}();

/// The value must be that of an enumerator.
template <NamedEnum E>
[[nodiscard]] constexpr std::string_view name(E value) {
    constexpr std::array<EnumName<E>, kCount<E>> kNames = enum_names(E{});
    return kNames[static_cast<std::size_t>(value)].name;
}

template <NamedEnum E>
[[nodiscard]] constexpr std::optional<E> find(std::string_view text) {
    for (const EnumName<E>& entry : enum_names(E{})) {
        if (!text.empty() && entry.name == text) return entry.value;
    }
    return std::nullopt;
}

}  // namespace poolhall
