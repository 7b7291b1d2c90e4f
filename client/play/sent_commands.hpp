#pragma once

#include "protocol/messages.hpp"

#include <deque>
#include <optional>

namespace poolhall::client {

/// Numbers what goes out over one connection, and remembers the commands that are not answered yet.
class SentCommands {
  public:
    static constexpr std::size_t kMaxUnanswered = 64;  ///< older ones are forgotten

    /// A new connection counts from 1, and answers nothing of before.
    void restart();

    /// The next message; its answer is of no interest.
    [[nodiscard]] protocol::ClientMessage number(protocol::ClientBody body);
    /// The next message, remembered until it is answered.
    [[nodiscard]] protocol::ClientMessage add(protocol::ClientBody body);

    /// The command that this answer is for; nothing if it is of no interest.
    [[nodiscard]] std::optional<protocol::ClientBody> take(std::uint32_t seq);

  private:
    std::uint32_t last_seq_ = 0;
    std::deque<protocol::ClientMessage> unanswered_;
};

}  // namespace poolhall::client
