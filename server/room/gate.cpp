#include "server/room/gate.hpp"

#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace poolhall::server {

using namespace protocol;  // the commands and codes of which this file is made

namespace {

using Answer = Gate::Answer;

Answer refuse(RejectCode code, std::string reason) {
    return Refusal{code, std::move(reason)};
}

Answer refuse_illegal(std::string_view field, const char* what) {
    return refuse(RejectCode::kIllegal, "field /move" + std::string(field) + " " + what);
}

Answer refuse_illegal(const IllegalMove& illegal) {
    switch (illegal.code) {
        case Illegal::kNotOffered:
            return refuse_illegal(illegal.field, "is no move that the rules offer now");
        case Illegal::kOutOfRegion:
            return refuse_illegal(illegal.field, "is no place where the cue ball may be put now");
        case Illegal::kBadDirection:
            return refuse_illegal(illegal.field, "must be finite and not zero");
        case Illegal::kOutOfBounds:
            return refuse_illegal(illegal.field, "is outside what the game allows");
    }
    return refuse(RejectCode::kIllegal, "The rules do not allow that.");
}

Answer refuse(const MoveRefusal& refusal) {
    switch (refusal.fault) {
        case MoveFault::kNotYourTurn:
            return refuse(RejectCode::kNotYourTurn, "It is the other seat's turn.");
        case MoveFault::kGameOver:
            return refuse(RejectCode::kWrongPhase, "The game is over.");
        case MoveFault::kNotOver:
            return refuse(RejectCode::kWrongPhase, "The game is not over.");
        case MoveFault::kClockStillRuns:
            return refuse(RejectCode::kIllegal, "The clock has not run down.");
        case MoveFault::kIllegal:
            break;
    }
    return refuse_illegal(refusal.illegal);
}

constexpr const char* kShotRuns = "A shot is running.";

}  // namespace

Answer check(const CreateMatch& command) {
    const Ruleset* rules = find_ruleset(command.game);
    if (!rules) return refuse(RejectCode::kUnknownGame, "There is no game of this name.");
    const auto fault = poolhall::check(*rules, command.settings.value_or(MatchSettings{}));
    if (!fault) return {};
    return refuse(RejectCode::kBadField, "field /settings" + fault->pointer + " " + fault->reason);
}

// ---- people

Answer Gate::operator()(const CreateMatch&) const {
    return {};  // the table was made for it
}

Answer Gate::operator()(const JoinMatch&) const {
    if (table_.roster.open_seat()) return {};
    return refuse(RejectCode::kMatchFull, "Both seats of this match are taken.");
}

Answer Gate::operator()(const WatchMatch&) const {
    if (table_.roster.spectators() < max_spectators_) return {};
    return refuse(RejectCode::kSpectatorsFull, "This match has as many spectators as it may have.");
}

Answer Gate::operator()(const Resume& command) const {
    if (!table_.roster.seats_of(hash_token(command.token)).empty()) return {};
    return refuse(RejectCode::kBadToken, "The token holds no seat in this match.");
}

Answer Gate::operator()(const TakeSeat& command) const {
    if (!table_.roster.holder(command.seat)) return {};
    return refuse(RejectCode::kSeatTaken, "That seat is taken.");
}

Answer Gate::operator()(const LeaveSeat& command) const {
    if (Answer answer = holds(command.seat)) return answer;
    return no_shot_runs("A seat cannot be left while a shot runs.");
}

Answer Gate::operator()(const Leave&) const {
    if (table_.roster.seats_of(member_).empty()) return {};
    return no_shot_runs("A seat cannot be left while a shot runs.");
}

Answer Gate::holds(Seat seat) const {
    if (table_.roster.holds(member_, seat)) return {};
    return refuse(RejectCode::kNotYourSeat, "You do not hold that seat.");
}

Answer Gate::no_shot_runs(const char* otherwise) const {
    if (!table_.playout) return {};
    return refuse(RejectCode::kWrongPhase, otherwise);
}

// ---- the game

Answer Gate::operator()(const MakeMove& command) const {
    if (Answer answer = holds(command.seat)) return answer;
    if (Answer answer = no_shot_runs(kShotRuns)) return answer;
    if (phase_of(table_) == Phase::kWaiting)
        return refuse(RejectCode::kWrongPhase, "A seat is open: the game waits for a player.");
    if (std::holds_alternative<TimeOut>(command.move))
        return refuse(RejectCode::kIllegal, "The server keeps the clock: no seat calls time.");
    // Only a time-out asks for the time.
    constexpr std::int64_t kAnyTime = std::numeric_limits<std::int64_t>::max();
    const auto refusal = table_.match.find_fault(command.seat, command.move, kAnyTime);
    return refusal ? refuse(*refusal) : Answer();
}

Answer Gate::operator()(const Aim& command) const {
    // Who may not shoot has nothing to aim.
    const Shoot shot{Stroke{command.direction, {}}};
    if (Answer answer = (*this)(MakeMove{command.seat, shot})) return answer;
    if (!command.cue || table_.match.now().legal.place) return {};
    return refuse(RejectCode::kIllegal,
                  "field /cue is not wanted now: the cue ball is not in hand");
}

}  // namespace poolhall::server
