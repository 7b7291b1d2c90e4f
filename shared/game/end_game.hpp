#pragma once

#include "shared/game/ruleset.hpp"

namespace poolhall {

/// Parberry's Pool End Game at Poolhall's scale: 16 px of the original are one ball radius, 28.575
/// mm.
namespace end_game {

inline constexpr double kPixel = 0.028575 / 16;      ///< m
inline constexpr double kLength = 868 * kPixel;      ///< playfield x 78..946 px
inline constexpr double kWidth = 403 * kPixel;       ///< playfield y 64..467 px
inline constexpr double kBaseLineX = -217 * kPixel;  ///< x = 295 px
inline constexpr double kFootSpotX = 220 * kPixel;   ///< x = 732 px
inline constexpr double kShotSpeed = 1500 * kPixel;  ///< m/s
inline constexpr double kDrag = 0.6;                 ///< 1/s
inline constexpr double kStopSpeed = 0.0625;         ///< m/s; 35 px/s rounded

inline constexpr std::string_view kCueBallId = "cue";
inline constexpr std::string_view kEightBallId = "8";

/// What the rules say of a shot that was played from this state. The cue ball down loses at once,
/// even if the 8-ball is down already; the 8-ball down wins only once everything is at rest, or the
/// shot has come to a limit.
[[nodiscard]] Ruling rule(const GameState& state, const ShotTrace& trace);

}  // namespace end_game

extern const Ruleset kEndGameRules;

}  // namespace poolhall
