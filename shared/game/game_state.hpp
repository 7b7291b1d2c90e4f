#pragma once

#include "shared/physics/scene/scene.hpp"
#include "shared/physics/scene/trace.hpp"

#include <compare>
#include <cstdint>
#include <optional>

namespace poolhall {

/// One of the two places at the table: 0 or 1.
struct Seat {
    std::uint8_t value = 0;

    friend constexpr auto operator<=>(const Seat&, const Seat&) = default;
};

inline constexpr int kSeatCount = 2;

constexpr Seat opponent(Seat seat) {
    return Seat{static_cast<std::uint8_t>(1 - seat.value)};
}

/// A game between shots; everything at rest.
struct GameState {
    Scene scene;         ///< table, effects, solver and the balls still on the table; no strike
    BallIndex cue_ball;  ///< in scene.balls, always: after a scratch it is back on the base line
    Seat turn;           ///< who shoots next; once over, who shot last
    std::uint32_t shots = 0;  ///< shots taken in this game
    bool over = false;
    std::optional<Seat> winner;  ///< set when over

    friend bool operator==(const GameState&, const GameState&) = default;
};

enum class Verdict : std::uint8_t {
    kTurnPasses,
    kWon,      ///< the shooter wins
    kScratch,  ///< the cue ball went down, or over a rail: the shooter loses
};

constexpr auto enum_names(Verdict /*type*/) {
    return names_of<Verdict>({{Verdict::kTurnPasses, "turn_passes"},
                              {Verdict::kWon, "won"},
                              {Verdict::kScratch, "scratch"}});
}

/// What the rules say of a shot.
struct Ruling {
    Verdict verdict = Verdict::kTurnPasses;
    Seat shooter;
    Seat next;                   ///< who shoots next, if the game goes on
    std::optional<Seat> winner;  ///< if the shot ended the game
    double decided_at = 0;  ///< s into the shot when it became certain; a scratch loses at once

    friend bool operator==(const Ruling&, const Ruling&) = default;
};

/// What a shot did to a game.
struct ShotOutcome {
    GameState state;
    Scene scene;  ///< what was simulated: the state's scene with the strike in it
    ShotTrace trace;
    Ruling ruling;
};

}  // namespace poolhall
