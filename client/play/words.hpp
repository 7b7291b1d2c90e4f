#pragma once

#include "client/play/shown_table.hpp"
#include "client/play/view_state.hpp"

#include <cstdint>
#include <string>

namespace poolhall::client {

/// One line that tells what to do now, or who is at it.
[[nodiscard]] std::string hint(const MatchInfo& info, const ShownTable& shown, bool step_mode);

/// The large message of the moment: how the game ended, that the connection is lost, why there is
/// no table.
[[nodiscard]] std::optional<Banner> banner(const MatchInfo& info, const ShownTable& shown);

/// Whether the result is good news for who sits here. A spectator and a hot seat share the winner's
/// joy.
[[nodiscard]] Tone tone_of(const Ruling& result, const MatchInfo& info);

/// The ruling as who sits here reads it; the table must be known.
[[nodiscard]] std::string ruling_sentence(const Ruling& ruling, const MatchInfo& info);

/// "event, slide_roll; called for: sliding, rolling. Ruled out: jump (level cue)": the solver, and
/// if there was a shot the kernel of the last one, and what of its physics it called for.
[[nodiscard]] std::string physics_of(const MatchInfo& info);

/// "45 s", "1:05 min": what is left of a turn.
[[nodiscard]] std::string clock_text(std::uint32_t seconds);

/// Whether the match is played with other physics than its game's own.
[[nodiscard]] bool has_own_physics(const MatchInfo& info);

}  // namespace poolhall::client
