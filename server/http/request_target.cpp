#include "server/http/request_target.hpp"

#include "server/http/authority.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

namespace poolhall::server {
namespace {

/// The length of "http://" or the like at the text's beginning; 0 if there is none.
std::size_t scheme_size(std::string_view text) {
    constexpr std::array<std::string_view, 4> kSchemes{"http://", "https://", "ws://", "wss://"};
    const auto same = [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) == b;
    };
    for (const std::string_view scheme : kSchemes) {
        const std::string_view begin = text.substr(0, scheme.size());
        if (std::equal(begin.begin(), begin.end(), scheme.begin(), scheme.end(), same))
            return scheme.size();
    }
    return 0;
}

/// A whole URI as path and host; nothing if its authority is none.
std::optional<RequestTarget> split(std::string_view uri) {
    const std::size_t end = std::min(uri.find_first_of("/?#"), uri.size());
    const std::string_view host = uri.substr(0, end);
    const auto authority = parse_authority(host);
    if (!authority || authority->host.empty()) return std::nullopt;
    std::string path(uri.substr(end));
    if (!path.starts_with('/')) path.insert(0, "/");
    return RequestTarget{std::move(path), std::string(host)};
}

}  // namespace

Result<RequestTarget, HttpReply> read_target(unsigned version, std::string_view target,
                                             const std::vector<std::string_view>& hosts) {
    constexpr unsigned kHttp10 = 10;
    if (hosts.empty() && version > kHttp10)
        return error_reply(400, "A request needs a Host field.");
    if (hosts.size() > 1) return error_reply(400, "A request has one Host field, not two.");
    if (!hosts.empty() && !parse_authority(hosts.front()))
        return error_reply(400, "The Host field is not HOST or HOST:PORT.");
    if (const std::size_t scheme = scheme_size(target)) {
        auto whole = split(target.substr(scheme));
        if (!whole) return error_reply(400, "The request's target names no host.");
        return *std::move(whole);
    }
    return RequestTarget{std::string(target), std::string(hosts.empty() ? "" : hosts.front())};
}

}  // namespace poolhall::server
