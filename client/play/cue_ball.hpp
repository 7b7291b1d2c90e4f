#pragma once

#include "protocol/messages.hpp"

#include <optional>

namespace poolhall::client {

// The cue ball of a table. In hand it is held somewhere, for all to see, until the move `place`
// puts it there.

/// Where it is shown, m.
[[nodiscard]] Vec2 cue_ball_of(const protocol::TableState& table);

/// Where the move `place` has to put it before a shot, m; nothing if it lies there already.
[[nodiscard]] std::optional<Vec2> unplaced_cue_ball(const protocol::TableState& table);

/// The table's state with the cue ball where it is shown.
[[nodiscard]] GameState shown_state(const protocol::TableState& table);

/// Holds the cue ball at the legal place nearest to `position` (m), and points the aim anew. False
/// if that changes nothing: it is not in hand, or there already.
bool hold_cue_ball(protocol::TableState& table, Vec2 position);

}  // namespace poolhall::client
