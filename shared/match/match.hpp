#pragma once

#include "shared/game/ruleset.hpp"
#include "shared/match/history.hpp"
#include "shared/match/position.hpp"
#include "shared/match/settings.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

namespace poolhall {

struct MatchSpec {
    const Ruleset* rules = nullptr;
    Seat first;                ///< breaks in the first game; seat 0 where the turns are solo
    MatchSettings settings{};  ///< must have passed the rules' check()
};

/// Why a match does not take a move from a seat.
enum class MoveFault : std::uint8_t {
    kNotYourTurn,
    kGameOver,        ///< the game is; only a rematch can follow
    kNotOver,         ///< a rematch is for when it is
    kClockStillRuns,  ///< or there is none
    kIllegal,         ///< by the rules of the game
};

struct MoveRefusal {
    MoveFault fault = MoveFault::kIllegal;
    IllegalMove illegal{};  ///< with kIllegal
};

// ---- what a move makes happen, in order

struct CueBallPlaced {
    Vec2 position;  ///< m
};

struct ShotTaken {
    std::uint32_t shot = 0;  ///< from 1, within the match
    SimulatedShot simulated;
};

struct Ruled {
    Ruling ruling;
};

struct GameWon {
    Seat winner;
};

/// The race is over.
struct MatchWon {
    Seat winner;
};

struct Consented {
    Seat seat;
    Accord to = Accord::kRematch;
};

struct GameBegan {
    std::uint32_t game_number = 1;
    Seat first;
};

using MatchEvent =
    std::variant<CueBallPlaced, ShotTaken, Ruled, GameWon, MatchWon, Consented, GameBegan>;

/// A move and all that it makes of a match. Nothing of it has happened before the match takes it.
struct MatchStep {
    MadeMove made;
    std::vector<MatchEvent> events;
    Position after;
    bool recorded = false;  ///< made elsewhere: playing the move again may give another position

    /// The shot of the step, if it was one.
    [[nodiscard]] const ShotTaken* shot() const;
    [[nodiscard]] std::optional<Ruling> ruling() const;
};

/// A match of two seats: moves in, events out, history kept. A pure state machine: it knows no
/// people, sockets, threads or files, and what time it is comes in with each move, in ms since any
/// one moment.
///
/// A move is played in two steps: play() says what comes of it and changes nothing, so that it can
/// be made durable first; commit() makes it so.
class Match {
  public:
    explicit Match(const MatchSpec& spec);

    [[nodiscard]] const Ruleset& rules() const { return *spec_.rules; }

    [[nodiscard]] const MatchSettings& settings() const { return spec_.settings; }

    /// Where the match stands.
    [[nodiscard]] const Position& now() const { return now_; }

    /// Why the seat may not make the move now; nothing if it may. Changes nothing.
    [[nodiscard]] std::optional<MoveRefusal> find_fault(Seat seat, const Move& move,
                                                        std::int64_t at_ms) const;

    /// What comes of a move in which find_fault() finds nothing.
    [[nodiscard]] MatchStep play(Seat seat, const Move& move, std::int64_t at_ms) const;

    /// The step of a move that was played elsewhere, with what came of it there: to go on from a
    /// record that cannot be repeated.
    [[nodiscard]] MatchStep recorded(const MadeMove& made, const Turn& turn) const;

    /// Takes a step that was made of this position. `at_ms`: when everybody has seen it; where it
    /// has ended a turn, the next one's clock runs from there.
    void commit(MatchStep step, std::int64_t at_ms);

    /// The clock of the turn runs from `at_ms`: a game goes on that had stood still.
    void start_clock(std::int64_t at_ms);

    /// Somebody else takes the seat: its score and its consent begin anew.
    void reset_seat(Seat seat);

    /// When the clock of the seat whose turn it is runs down, ms; nothing if it does not run: none
    /// was agreed on, it has not been started, or the game is over.
    [[nodiscard]] std::optional<std::int64_t> clock_ends_ms() const;

    /// Who breaks in the game after this one, which must be over unless breaks alternate.
    [[nodiscard]] Seat next_first() const;

    // ---- history
    /// The moves so far.
    [[nodiscard]] const std::vector<MadeMove>& moves() const { return history_.moves(); }

    /// Where the match stood after the first `count` moves; any count up to moves().size(), in any
    /// order. Plays again what lies between there and the last kept position: up to
    /// MatchHistory::kSpacing moves. Scores are as they were then.
    [[nodiscard]] Position at(std::size_t count) const;

    /// What move `index` made of the match, played again; a recorded() one too, by the physics of
    /// today.
    [[nodiscard]] MatchStep step(std::size_t index) const;

  private:
    MatchSpec spec_;
    Position now_;
    MatchHistory history_;
    std::optional<std::int64_t> clock_since_ms_;  ///< the clock of this turn runs from here
};

}  // namespace poolhall
