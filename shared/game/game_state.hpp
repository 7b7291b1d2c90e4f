#pragma once

#include "shared/enum_names.hpp"
#include "shared/fields.hpp"
#include "shared/game/end_game_part.hpp"
#include "shared/game/seat.hpp"
#include "shared/physics/scene/scene.hpp"

#include <cstdint>
#include <optional>
#include <tuple>
#include <variant>

namespace poolhall {

/// The list of games, each by what it keeps besides what all have: kType is its name, rules() are
/// its rules. Hashes know a game by its place: new ones go to the end.
using GamePart = std::variant<EndGamePart>;

/// A game between two moves, whole: everything at rest. With the match's settings it is all that
/// the rules ever look at.
struct GameState {
    Scene scene;         ///< table, effects, solver and the balls still on the table; no strike
    BallIndex cue_ball;  ///< in scene.balls, always: after a scratch it is back on the table
    Seat turn;           ///< whose decision is next; once over, whose was the last
    std::uint32_t shots = 0;  ///< taken in this game
    bool over = false;
    std::optional<Seat> winner;  ///< set when over
    GamePart part;

    static constexpr auto field_list() {
        return std::tuple{
            fields::of("scene", &GameState::scene), fields::of("cue_ball", &GameState::cue_ball),
            fields::of("turn", &GameState::turn),   fields::of("shots", &GameState::shots),
            fields::of("over", &GameState::over),   fields::of("winner", &GameState::winner),
            fields::of("part", &GameState::part)};
    }

    friend bool operator==(const GameState&, const GameState&) = default;
};

/// Hash of the whole state: equal states, and no others but by accident, have equal hashes, on
/// every machine. What follows from a state follows from any with its hash.
[[nodiscard]] std::uint64_t hash_of(const GameState& state);

/// What the rules say of a move. Sentences are made where they are shown.
enum class Verdict : std::uint8_t {
    kTurnPasses,
    kWon,       ///< the seat that shot wins
    kScratch,   ///< the cue ball went down, or over a rail: the seat that shot loses
    kConceded,  ///< the seat gave the game up
    kTimedOut,  ///< the seat had used up its time: the turn passes
};

constexpr auto enum_names(Verdict /*type*/) {
    return names_of<Verdict>({{Verdict::kTurnPasses, "turn_passes"},
                              {Verdict::kWon, "won"},
                              {Verdict::kScratch, "scratch"},
                              {Verdict::kConceded, "conceded"},
                              {Verdict::kTimedOut, "timed_out"}});
}

struct Ruling {
    Verdict verdict = Verdict::kTurnPasses;
    Seat shooter;                ///< whose move it was
    Seat next;                   ///< whose decision is next, if the game goes on
    std::optional<Seat> winner;  ///< if the move ended the game
    double decided_at = 0;  ///< s into the shot when it became certain; a scratch loses at once

    friend bool operator==(const Ruling&, const Ruling&) = default;
};

}  // namespace poolhall
