#include "client/play/entrance.hpp"

namespace poolhall::client {

using protocol::ClientBody;
using protocol::RejectCode;

ClientBody Entrance::request() {
    if (wanted_.watch) return protocol::WatchMatch{wanted_.code, wanted_.name};
    if (wanted_.code.empty()) return new_match();
    if (token_.empty()) token_ = tokens_.claim(wanted_.server, wanted_.code).value_or("");
    if (token_.empty()) return protocol::JoinMatch{wanted_.code, wanted_.name};
    return protocol::Resume{wanted_.code, token_};
}

protocol::CreateMatch Entrance::new_match() const {
    protocol::CreateMatch match{wanted_.name};
    if (wanted_.settings != MatchSettings{}) match.settings = wanted_.settings;
    return match;
}

void Entrance::entered(const protocol::Joined& joined) {
    wanted_.code = joined.table.code;
    if (joined.token.empty()) return;
    token_ = joined.token;
    tokens_.keep(wanted_.server, wanted_.code, token_);
}

std::optional<ClientBody> Entrance::request_after(RejectCode refusal) {
    const bool outdated = refusal == RejectCode::kBadToken || refusal == RejectCode::kUnknownMatch;
    if (token_.empty() || !outdated) return std::nullopt;
    tokens_.forget(token_);
    token_.clear();
    if (refusal == RejectCode::kUnknownMatch) return std::nullopt;
    return request();
}

}  // namespace poolhall::client
