#pragma once

#include "client/play/token_keeper.hpp"
#include "protocol/messages.hpp"

#include <optional>
#include <string>
#include <utility>

namespace poolhall::client {

/// Which match the player wants to be in, and as whom.
struct EntryRequest {
    std::string server;  ///< "host:port"; tokens are kept for it
    std::string code;    ///< as normalize_code gives it; empty: a new match
    std::string name;
    bool watch = false;        ///< as a spectator
    MatchSettings settings{};  ///< of a new match
};

/// How to get into the match, first and after every loss of the connection: by a token for a seat
/// held before, as a newcomer, or as a spectator.
class Entrance {
  public:
    Entrance(EntryRequest wanted, TokenKeeper& tokens)
        : wanted_(std::move(wanted)), tokens_(tokens) {}

    /// What to ask a server that has just said welcome.
    [[nodiscard]] protocol::ClientBody request();
    void entered(const protocol::Joined& joined);
    /// What to ask instead after a refusal; nothing if there is no other way in.
    [[nodiscard]] std::optional<protocol::ClientBody> request_after(protocol::RejectCode refusal);

  private:
    [[nodiscard]] protocol::CreateMatch new_match() const;

    EntryRequest wanted_;  ///< its code becomes that of the match once it is known
    TokenKeeper& tokens_;
    std::string token_;
};

}  // namespace poolhall::client
