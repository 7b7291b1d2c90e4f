#pragma once

#include <string>
#include <string_view>

namespace poolhall::server {

/// Text from outside as it may stand in a log line: in quotes, everything but printable ASCII as
/// \xHH, so that nobody's name can forge a line or drive a terminal.
[[nodiscard]] std::string in_quotes(std::string_view text);

}  // namespace poolhall::server
