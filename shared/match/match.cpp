#include "shared/match/match.hpp"

#include <cassert>
#include <utility>

namespace poolhall {

namespace {

constexpr Seat kSoloSeat{0};

Position begin_game(const MatchSpec& spec, Seat first) {
    Position position;
    position.first = first;
    position.game = new_game(*spec.rules, first, spec.settings.game);
    position.legal = spec.rules->legal(position.game);
    return position;
}

Seat first_of(const MatchSpec& spec) {
    return spec.settings.turns == Turns::kSolo ? kSoloSeat : spec.first;
}

Seat first_after(const MatchSettings& settings, const Position& position) {
    if (settings.turns == Turns::kSolo) return kSoloSeat;
    const Seat winner = position.game.winner.value_or(opponent(position.first));
    switch (settings.breaks) {
        case BreakOrder::kWinner:
            return winner;
        case BreakOrder::kLoser:
            return opponent(winner);
        case BreakOrder::kAlternate:
            break;
    }
    return opponent(position.first);
}

/// Makes the steps of one position.
class Stepper {
  public:
    Stepper(const MatchSpec& spec, const Position& before) : spec_(spec) { step_.after = before; }

    MatchStep play(const MadeMove& made) {
        step_.made = made;
        if (const auto* agree = std::get_if<Agree>(&made.move)) {
            consent(made.seat, agree->what);
        } else if (std::holds_alternative<Concede>(made.move)) {
            take(concede(step_.after.game, made.seat));
        } else {
            take(spec_.rules->play(step_.after.game, made.move));
        }
        step_.made.state = hash_of(step_.after.game);
        return std::move(step_);
    }

    MatchStep repeat(const MadeMove& made, const Turn& turn) {
        step_.made = made;
        step_.recorded = true;
        take(turn);
        return std::move(step_);
    }

  private:
    void take(Turn turn) {
        Position& now = step_.after;
        if (const auto* place = std::get_if<Place>(&step_.made.move))
            step_.events.emplace_back(CueBallPlaced{place->position});
        if (turn.shot) {
            ++now.shots;
            step_.events.emplace_back(ShotTaken{now.shots, *std::move(turn.shot)});
        }
        now.game = std::move(turn.state);
        if (spec_.settings.turns == Turns::kSolo) keep_turn(turn.ruling);
        if (turn.ruling) {
            now.ruling = turn.ruling;
            step_.events.emplace_back(Ruled{*turn.ruling});
        }
        now.legal = spec_.rules->legal(now.game);
        if (now.game.over && now.game.winner) win(*now.game.winner);
    }

    /// Nobody else is there to take the turn.
    void keep_turn(std::optional<Ruling>& ruling) {
        if (!step_.after.game.over) step_.after.game.turn = kSoloSeat;
        if (ruling) ruling->next = kSoloSeat;
    }

    void win(Seat winner) {
        Position& now = step_.after;
        const std::uint32_t wins = ++now.wins[winner.value];
        step_.events.emplace_back(GameWon{winner});
        if (spec_.settings.race_to == 0 || wins < spec_.settings.race_to) return;
        now.winner = winner;
        step_.events.emplace_back(MatchWon{winner});
    }

    void consent(Seat seat, Accord what) {
        Position& now = step_.after;
        now.consents[seat.value] = true;
        step_.events.emplace_back(Consented{seat, what});
        const bool alone = spec_.settings.turns == Turns::kSolo;
        if (alone || now.consents[opponent(seat).value]) begin_next_game();
    }

    void begin_next_game() {
        const Position& before = step_.after;
        Position next = begin_game(spec_, first_after(spec_.settings, before));
        next.game_number = before.game_number + 1;
        next.shots = before.shots;
        if (!before.winner) next.wins = before.wins;
        step_.events.emplace_back(GameBegan{next.game_number, next.first});
        step_.after = std::move(next);
    }

    const MatchSpec& spec_;
    MatchStep step_;
};

template <class Event>
const Event* find_event(const MatchStep& step) {
    for (const MatchEvent& event : step.events)
        if (const auto* found = std::get_if<Event>(&event)) return found;
    return nullptr;
}

}  // namespace

const ShotTaken* MatchStep::shot() const {
    return find_event<ShotTaken>(*this);
}

std::optional<Ruling> MatchStep::ruling() const {
    const auto* ruled = find_event<Ruled>(*this);
    return ruled ? std::optional(ruled->ruling) : std::nullopt;
}

Match::Match(const MatchSpec& spec)
    : spec_(spec), now_(begin_game(spec_, first_of(spec_))), history_(now_) {}

std::optional<MoveRefusal> Match::find_fault(Seat seat, const Move& move,
                                             std::int64_t at_ms) const {
    if (std::holds_alternative<Agree>(move)) {
        if (now_.game.over) return std::nullopt;
        return MoveRefusal{MoveFault::kNotOver};
    }
    if (now_.game.over) return MoveRefusal{MoveFault::kGameOver};
    if (std::holds_alternative<Concede>(move)) return std::nullopt;
    if (seat != now_.legal.seat) return MoveRefusal{MoveFault::kNotYourTurn};
    if (std::holds_alternative<TimeOut>(move)) {
        const auto end = clock_ends_ms();
        if (end && at_ms >= *end) return std::nullopt;
        return MoveRefusal{MoveFault::kClockStillRuns};
    }
    if (const auto illegal = poolhall::find_fault(now_.legal, move))
        return MoveRefusal{MoveFault::kIllegal, *illegal};
    return std::nullopt;
}

MatchStep Match::play(Seat seat, const Move& move, std::int64_t at_ms) const {
    assert(!find_fault(seat, move, at_ms));
    return Stepper(spec_, now_).play({seat, completed(now_.legal, move), at_ms, 0});
}

MatchStep Match::recorded(const MadeMove& made, const Turn& turn) const {
    return Stepper(spec_, now_).repeat(made, turn);
}

void Match::commit(MatchStep step, std::int64_t at_ms) {
    now_ = std::move(step.after);
    history_.add(step.made, now_);
    if (step.recorded) history_.keep(now_);
    // A ball that is placed, or one seat's consent, gives nobody more time.
    if (step.ruling() || find_event<GameBegan>(step)) start_clock(at_ms);
}

void Match::reset_seat(Seat seat) {
    now_.wins[seat.value] = 0;
    now_.consents[seat.value] = false;
    history_.keep(now_);
}

void Match::start_clock(std::int64_t at_ms) {
    clock_since_ms_ = at_ms;
}

std::optional<std::int64_t> Match::clock_ends_ms() const {
    if (!spec_.settings.shot_clock_s || !clock_since_ms_ || now_.game.over) return std::nullopt;
    return *clock_since_ms_ + std::int64_t{1000} * *spec_.settings.shot_clock_s;
}

Seat Match::next_first() const {
    return first_after(spec_.settings, now_);
}

Position Match::at(std::size_t count) const {
    assert(count <= moves().size());
    const MatchHistory::Kept& kept = history_.last_kept(count);
    Position position = kept.position;
    for (std::size_t i = kept.moves; i < count; ++i)
        position = Stepper(spec_, position).play(moves()[i]).after;
    return position;
}

MatchStep Match::step(std::size_t index) const {
    const Position before = at(index);
    return Stepper(spec_, before).play(moves()[index]);
}

}  // namespace poolhall
