#pragma once

#include "protocol/messages.hpp"
#include "server/room/request.hpp"
#include "server/room/table.hpp"

#include <cstdint>
#include <optional>

namespace poolhall::server {

/// Whether there can be such a match: its game is known and its settings are fit for it.
[[nodiscard]] std::optional<Refusal> check(const protocol::CreateMatch& command);

/// Whether a table can carry out a member's command: seat, phase, turn, rules, in this order.
/// Changes nothing, so that a refused command cannot leave a trace; what it lets pass may be asked
/// of the table.
class Gate {
  public:
    using Answer = std::optional<Refusal>;

    Gate(const Table& table, MemberId member, std::uint32_t max_spectators)
        : table_(table), member_(member), max_spectators_(max_spectators) {}

    Answer operator()(const protocol::CreateMatch& command) const;
    Answer operator()(const protocol::JoinMatch& command) const;
    Answer operator()(const protocol::WatchMatch& command) const;
    Answer operator()(const protocol::Resume& command) const;
    Answer operator()(const protocol::TakeSeat& command) const;
    Answer operator()(const protocol::LeaveSeat& command) const;
    Answer operator()(const protocol::Leave& command) const;
    Answer operator()(const protocol::MakeMove& command) const;
    Answer operator()(const protocol::Aim& command) const;

  private:
    [[nodiscard]] Answer holds(Seat seat) const;
    [[nodiscard]] Answer no_shot_runs(const char* otherwise) const;

    const Table& table_;
    MemberId member_;
    std::uint32_t max_spectators_;
};

}  // namespace poolhall::server
