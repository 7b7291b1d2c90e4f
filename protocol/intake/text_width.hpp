#pragma once

#include <cstddef>
#include <string_view>

namespace poolhall::protocol {

/// Places that a line of UTF-8 takes on a terminal: two for a wide character, none for one that
/// combines with another. A byte that is no UTF-8 takes one.
[[nodiscard]] std::size_t text_width(std::string_view text);

}  // namespace poolhall::protocol
