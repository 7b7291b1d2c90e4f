#pragma once

#include "protocol/messages.hpp"
#include "server/room/playout.hpp"
#include "server/room/roster.hpp"
#include "shared/match/match.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace poolhall::server {

/// What the seat whose turn it is shows the others of its intentions. It decides nothing.
struct ShownAim {
    Vec2 direction{1, 0};
    std::optional<Vec2> cue;  ///< where the cue ball in hand is held, m

    friend bool operator==(const ShownAim&, const ShownAim&) = default;
};

/// One table: the match, the people at it, and what is shown but not yet or never part of the
/// match. It knows no socket, thread, clock or store.
struct Table {
    Table(std::string match_id, std::string join_code, const MatchSpec& spec);

    std::string id;  ///< of the match and of its replay
    std::string code;
    Match match;
    Roster roster;
    ShownAim aim;
    std::optional<Playout> playout;  ///< the shot that runs; the match stands as before it

    /// The step becomes part of the match, and the aim turns to where the rules point it.
    void commit(MatchStep step, std::int64_t now_ms);
    // A seat that changes hands begins anew.
    void take_seat(Seat seat, SeatHolder holder);
    void leave_seat(Seat seat);
    void leave(MemberId member);
};

[[nodiscard]] protocol::Phase phase_of(const Table& table);

/// Whether the shot clock runs: in a game that waits for a move, while at least one of the players
/// is there. With nobody to move, turns would pass back and forth for nothing.
[[nodiscard]] bool clock_runs(const Table& table);

/// Where the cue ball is shown, m: where it is held, else where it lies.
[[nodiscard]] Vec2 shown_cue_ball(const Table& table);

/// All that everybody may know of it.
[[nodiscard]] protocol::TableState state_of(const Table& table, std::int64_t now_ms);

}  // namespace poolhall::server
