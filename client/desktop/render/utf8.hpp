#pragma once

#include <string>
#include <string_view>

namespace poolhall::client {

/// Text that can be drawn whatever was read: each byte that is no UTF-8 becomes U+FFFD, control
/// characters become spaces, and no more than 512 characters are kept.
[[nodiscard]] std::string legible(std::string_view text);

/// The first `count` characters of valid UTF-8.
[[nodiscard]] std::string_view first_characters(std::string_view text, std::size_t count);

}  // namespace poolhall::client
