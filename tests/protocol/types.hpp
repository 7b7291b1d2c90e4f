#pragma once

#include "protocol/wire/tagged.hpp"

#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace poolhall::protocol::testing {

/// Calls visitor with a std::type_identity of each alternative in the order of the list, those of
/// variants within it in their place.
template <class Visitor, class... Alternatives>
void for_each_alternative(std::type_identity<std::variant<Alternatives...>> /*list*/,
                          const Visitor& visitor) {
    const auto visit_one = [&]<class T>(std::type_identity<T> alternative) {
        if constexpr (wire::kIsVariant<T>)
            for_each_alternative(alternative, visitor);
        else
            visitor(alternative);
    };
    (visit_one(std::type_identity<Alternatives>{}), ...);
}

/// The "type" of each alternative.
template <class Variant>
std::vector<std::string> types_of() {
    std::vector<std::string> types;
    for_each_alternative(std::type_identity<Variant>{},
                         [&]<class T>(std::type_identity<T>) { types.emplace_back(T::kType); });
    return types;
}

}  // namespace poolhall::protocol::testing
