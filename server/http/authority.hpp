#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace poolhall::server {

/// HOST[:PORT] as of RFC 3986, section 3.2, without user information.
struct Authority {
    std::string host;  ///< lower case; an IPv6 address in its one form, in brackets; may be empty
    std::optional<std::uint16_t> port;
};

/// Nothing if the text is none.
[[nodiscard]] std::optional<Authority> parse_authority(std::string_view text);

/// Whether a page of this origin ("https://name") has come from where the Host field says that it
/// connects to. The scheme is not compared, since a proxy in front may speak TLS: the host is the
/// same, and so is the port, of which the default one of the origin's scheme is the same as none. A
/// Host's own :80 is none, too: it is the default of what is spoken here.
[[nodiscard]] bool is_own_origin(std::string_view origin, std::string_view host);

/// Whether two origins are one: RFC 6454, section 5.
[[nodiscard]] bool is_same_origin(std::string_view a, std::string_view b);

}  // namespace poolhall::server
