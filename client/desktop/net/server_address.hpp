#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace poolhall::client {

struct ServerAddress {
    std::string host;  ///< name or address; an IPv6 address without its brackets
    std::string port;  ///< decimal, 1 to 65535

    friend bool operator==(const ServerAddress&, const ServerAddress&) = default;
};

inline constexpr std::string_view kDefaultServer = "ws://127.0.0.1:8080";

/// Reads ws://host:port, http://host:port, host:port or host; a path behind it is ignored. The port
/// is 8080 if none is given. None if it is no such address.
[[nodiscard]] std::optional<ServerAddress> parse_server_address(std::string_view text);

/// "host:port", with brackets around an IPv6 address.
[[nodiscard]] std::string to_string(const ServerAddress& address);

}  // namespace poolhall::client
