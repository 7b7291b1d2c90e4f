#pragma once

#include "protocol/messages.hpp"
#include "server/room/match.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace poolhall::server {

/// Why a command is not carried out; what the client gets as a `reject`.
struct Refusal {
    protocol::RejectCode code = protocol::RejectCode::kIllegal;
    std::string reason;  ///< a sentence
};

/// Whether there can be such a match: its game is known and its settings are fit for it.
[[nodiscard]] std::optional<Refusal> check(const protocol::CreateMatch& command);

/// Whether the match can carry out the command for this member: seat, turn, phase, rules. Changes
/// nothing, so that a refused command cannot leave a trace; what it lets pass, Match does not
/// refuse. Commands that do not concern this match (create_match, ping) always pass.
[[nodiscard]] std::optional<Refusal> check(const Match& match, MemberId member,
                                           const protocol::ClientBody& command,
                                           std::uint32_t max_spectators);

}  // namespace poolhall::server
