#include "server/http/authority.hpp"

#include <algorithm>
#include <arpa/inet.h>
#include <array>
#include <charconv>
#include <cstddef>
#include <netinet/in.h>
#include <system_error>

namespace poolhall::server {
namespace {

constexpr std::uint16_t kHttpPort = 80;
constexpr std::uint16_t kHttpsPort = 443;

constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz";
/// What a registered name is made of beside letters and "%": unreserved and sub-delims.
constexpr std::string_view kOthers = "0123456789-._~!$&'()*+,;=";
constexpr std::string_view kHexDigits = "0123456789abcdef";

std::string lower(std::string_view text) {
    std::string result(text);
    for (char& c : result)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return result;
}

bool is_registered_name(std::string_view name) {
    for (std::size_t i = 0; i < name.size(); ++i) {
        if (name[i] != '%') {
            if (kLetters.find(name[i]) == std::string_view::npos &&
                kOthers.find(name[i]) == std::string_view::npos)
                return false;
        } else if (i + 2 >= name.size() ||
                   name.substr(i + 1, 2).find_first_not_of(kHexDigits) != std::string_view::npos) {
            return false;
        }
    }
    return true;
}

/// [ADDRESS] in the form that inet_ntop has; nothing if it is no IPv6 address.
std::optional<std::string> parse_literal(std::string_view literal) {
    in6_addr address{};
    std::array<char, INET6_ADDRSTRLEN> text{};
    const std::string bare(literal.substr(1, literal.size() - 2));
    if (inet_pton(AF_INET6, bare.c_str(), &address) != 1) return std::nullopt;
    if (inet_ntop(AF_INET6, &address, text.data(), text.size()) == nullptr) return std::nullopt;
    return "[" + std::string(text.data()) + "]";
}

/// What an origin is made of.
struct Origin {
    std::string scheme;
    Authority authority;
    std::optional<std::uint16_t> port;  ///< its own, or its scheme's default
};

std::optional<std::uint16_t> default_port(std::string_view scheme) {
    if (scheme == "http" || scheme == "ws") return kHttpPort;
    if (scheme == "https" || scheme == "wss") return kHttpsPort;
    return std::nullopt;
}

std::optional<Origin> parse_origin(std::string_view text) {
    const std::size_t end = text.find("://");
    if (end == std::string_view::npos || end == 0) return std::nullopt;
    auto authority = parse_authority(text.substr(end + 3));
    if (!authority || authority->host.empty()) return std::nullopt;
    Origin origin{lower(text.substr(0, end)), *authority, authority->port};
    if (!origin.port) origin.port = default_port(origin.scheme);
    return origin;
}

}  // namespace

std::optional<Authority> parse_authority(std::string_view text) {
    const std::size_t bracket = text.starts_with('[') ? text.find(']') : 0;
    if (bracket == std::string_view::npos) return std::nullopt;
    const std::size_t colon = std::min(text.find(':', bracket), text.size());
    Authority authority{lower(text.substr(0, colon)), {}};
    if (bracket > 0) {
        if (colon != bracket + 1) return std::nullopt;
        const auto literal = parse_literal(authority.host);
        if (!literal) return std::nullopt;
        authority.host = *literal;
    } else if (!is_registered_name(authority.host)) {
        return std::nullopt;
    }
    // RFC 3986 allows a colon without a port.
    const std::string_view digits = text.substr(std::min(colon + 1, text.size()));
    if (digits.empty()) return authority;
    std::uint16_t port = 0;
    const char* const end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, port);
    if (error != std::errc{} || stop != end) return std::nullopt;
    authority.port = port;
    return authority;
}

bool is_own_origin(std::string_view origin, std::string_view host) {
    const auto from = parse_origin(origin);
    const auto to = parse_authority(host);
    if (!from || !to || from->authority.host != to->host) return false;
    const auto none = default_port(from->scheme);
    if (!none) return false;  // no page of the web
    const bool is_none = !to->port || *to->port == kHttpPort;
    return from->port == to->port || (is_none && from->port == none);
}

bool is_same_origin(std::string_view a, std::string_view b) {
    const auto first = parse_origin(a);
    const auto second = parse_origin(b);
    if (!first || !second) return lower(a) == lower(b);  // "null", for one
    return first->scheme == second->scheme && first->authority.host == second->authority.host &&
           first->port == second->port;
}

}  // namespace poolhall::server
