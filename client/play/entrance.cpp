#include "client/play/entrance.hpp"

namespace poolhall::client {

using protocol::ClientBody;
using protocol::RejectCode;

ClientBody Entrance::request() {
    if (wish_.watch) return protocol::WatchMatch{wish_.code, wish_.name};
    if (wish_.code.empty()) return new_match();
    if (token_.empty()) token_ = tokens_.claim(wish_.server, wish_.code).value_or("");
    if (token_.empty()) return protocol::JoinMatch{wish_.code, wish_.name};
    return protocol::Resume{wish_.code, token_};
}

protocol::CreateMatch Entrance::new_match() const {
    protocol::CreateMatch match{wish_.name};
    if (wish_.settings != GameSettings{}) match.settings = wish_.settings;
    return match;
}

void Entrance::entered(const protocol::Joined& joined) {
    wish_.code = joined.table.code;
    if (joined.token.empty()) return;
    token_ = joined.token;
    tokens_.keep(wish_.server, wish_.code, token_);
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
