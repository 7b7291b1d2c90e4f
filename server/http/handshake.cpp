#include "server/http/handshake.hpp"

#include "protocol/limits.hpp"
#include "server/http/authority.hpp"

#include <algorithm>

namespace poolhall::server {
namespace {

/// A page may connect if it comes from where it connects to, or from where it may come from.
bool origin_allowed(const Handshake& handshake, const std::vector<std::string>& allowed) {
    if (!handshake.origin) return true;
    const std::string_view origin = *handshake.origin;
    if (allowed.empty()) return is_own_origin(origin, handshake.host);
    return std::any_of(allowed.begin(), allowed.end(), [&](const std::string& entry) {
        return entry == "*" || is_same_origin(entry, origin);
    });
}

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// The client's first choice that is one of ours. The view is to a name of ours.
std::optional<AcceptedHandshake> choose(std::string_view offered) {
    while (!offered.empty()) {
        const std::string_view entry = offered.substr(0, offered.find(','));
        offered.remove_prefix(std::min(offered.size(), entry.size() + 1));
        if (const auto encoding = protocol::encoding_of(trimmed(entry)))
            return AcceptedHandshake{*encoding, *encoding == protocol::Encoding::kJson
                                                    ? protocol::kSubprotocolJson
                                                    : protocol::kSubprotocolCbor};
    }
    return std::nullopt;
}

}  // namespace

std::variant<AcceptedHandshake, HttpReply> judge(const Handshake& handshake,
                                                 const std::vector<std::string>& allowed_origins) {
    if (handshake.target.substr(0, handshake.target.find('?')) != protocol::kPath)
        return error_reply(404, "WebSockets are at " + std::string(protocol::kPath) + ".");
    if (!origin_allowed(handshake, allowed_origins))
        return error_reply(403, "Pages of this origin may not connect.");
    if (!handshake.subprotocols) return AcceptedHandshake{};
    if (const auto chosen = choose(*handshake.subprotocols)) return *chosen;
    return error_reply(400, "None of these subprotocols is spoken here; the server offers " +
                                std::string(protocol::kSubprotocolJson) + " and " +
                                std::string(protocol::kSubprotocolCbor) + ".");
}

}  // namespace poolhall::server
