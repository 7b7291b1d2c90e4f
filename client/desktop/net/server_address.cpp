#include "client/desktop/net/server_address.hpp"

#include <algorithm>
#include <charconv>

namespace poolhall::client {
namespace {

constexpr std::string_view kDefaultPort = "8080";
constexpr std::size_t kMaxHostBytes = 253;

bool is_port(std::string_view text) {
    unsigned port = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
    return error == std::errc{} && end == text.data() + text.size() && port >= 1 && port <= 65535;
}

bool is_host(std::string_view text) {
    return !text.empty() && text.size() <= kMaxHostBytes &&
           std::all_of(text.begin(), text.end(), [](char c) {
               return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                      c == '.' || c == '-' || c == '_' || c == ':' || c == '%';
           });
}

void remove_scheme(std::string_view& text) {
    for (const std::string_view scheme : {"ws://", "http://"}) {
        if (text.starts_with(scheme)) {
            text.remove_prefix(scheme.size());
            return;
        }
    }
}

}  // namespace

std::optional<ServerAddress> parse_server_address(std::string_view text) {
    remove_scheme(text);
    text = text.substr(0, text.find('/'));
    std::string_view host = text;
    std::string_view port = kDefaultPort;
    const bool bracketed = text.starts_with('[');
    const auto colon = bracketed ? text.find("]:") : text.find(':');
    if (bracketed) {
        const auto close = text.find(']');
        if (close == std::string_view::npos) return std::nullopt;
        host = text.substr(1, close - 1);
        if (close + 1 != text.size() && colon != close) return std::nullopt;
        if (colon == close) port = text.substr(close + 2);
    } else if (colon != std::string_view::npos) {
        host = text.substr(0, colon);
        port = text.substr(colon + 1);
    }
    if (!is_host(host) || !is_port(port)) return std::nullopt;
    return ServerAddress{std::string(host), std::string(port)};
}

std::string to_string(const ServerAddress& address) {
    const bool ipv6 = address.host.find(':') != std::string::npos;
    return (ipv6 ? "[" + address.host + "]" : address.host) + ":" + address.port;
}

}  // namespace poolhall::client
