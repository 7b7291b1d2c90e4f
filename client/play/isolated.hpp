#pragma once

#include <string>
#include <string_view>

namespace poolhall::client {

/// A name as it goes into a sentence: between U+2068 and U+2069, so that a name written from right
/// to left keeps its own order and leaves that of the words around it alone. Marks of direction
/// inside it are left out: they would reach beyond it. A name in ASCII stays as it is.
[[nodiscard]] std::string isolated(std::string_view name);

}  // namespace poolhall::client
