#include "client/play/sent_commands.hpp"

#include <algorithm>
#include <utility>

namespace poolhall::client {

void SentCommands::restart() {
    last_seq_ = 0;
    unanswered_.clear();
}

protocol::ClientMessage SentCommands::number(protocol::ClientBody body) {
    return {++last_seq_, std::move(body)};
}

protocol::ClientMessage SentCommands::add(protocol::ClientBody body) {
    unanswered_.push_back(number(std::move(body)));
    protocol::ClientMessage message = unanswered_.back();
    if (unanswered_.size() > kMaxUnanswered) unanswered_.pop_front();
    return message;
}

std::optional<protocol::ClientBody> SentCommands::take(std::uint32_t seq) {
    const auto found = std::find_if(unanswered_.begin(), unanswered_.end(),
                                    [seq](const auto& command) { return command.seq == seq; });
    if (found == unanswered_.end()) return std::nullopt;
    protocol::ClientBody body = std::move(found->body);
    unanswered_.erase(found);
    return body;
}

}  // namespace poolhall::client
