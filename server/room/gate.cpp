#include "server/room/gate.hpp"

#include <string_view>
#include <utility>
#include <variant>

namespace poolhall::server {
namespace {

using namespace protocol;  // the commands and codes of which this file is made

using Answer = std::optional<Refusal>;

Answer refuse(RejectCode code, std::string_view reason) {
    return Refusal{code, std::string(reason)};
}

std::string_view explain(Illegal reason) {
    switch (reason) {
        case Illegal::kGameOver:
            return "The game is over.";
        case Illegal::kNotPlaceable:
            return "The cue ball may not be moved now.";
        case Illegal::kOutOfPlace:
            return "The cue ball may not be put there.";
        case Illegal::kBadDirection:
            return "The direction is zero or not finite.";
    }
    return "The rules do not allow that.";
}

Answer refuse(Illegal reason) {
    return refuse(RejectCode::kIllegal, explain(reason));
}

std::string_view explain(Phase phase) {
    switch (phase) {
        case Phase::kWaiting:
            return "A seat is open: the game waits for a player.";
        case Phase::kAiming:
            return "The game is not over.";
        case Phase::kPlaying:
            return "A shot is running.";
        case Phase::kOver:
            return "The game is over.";
    }
    return "Not now.";
}

struct Checks {
    const Match& match;
    MemberId member;
    std::uint32_t max_spectators;

    [[nodiscard]] Answer holds(Seat seat) const {
        if (match.holds(member, seat)) return {};
        return refuse(RejectCode::kNotYourSeat, "You do not hold that seat.");
    }

    [[nodiscard]] Answer in_phase(Phase wanted) const {
        if (match.phase() == wanted) return {};
        return refuse(RejectCode::kWrongPhase, explain(match.phase()));
    }

    [[nodiscard]] Answer may_act(Seat seat) const {
        if (Answer answer = holds(seat)) return answer;
        if (Answer answer = in_phase(Phase::kAiming)) return answer;
        if (match.game().turn != seat)
            return refuse(RejectCode::kNotYourTurn, "It is the other seat's turn.");
        return {};
    }

    [[nodiscard]] Answer may_free_seat() const {
        if (match.phase() != Phase::kPlaying) return {};
        return refuse(RejectCode::kWrongPhase, "A seat cannot be left while a shot runs.");
    }

    Answer operator()(const CreateMatch&) const { return {}; }

    Answer operator()(const Ping&) const { return {}; }

    Answer operator()(const JoinMatch&) const {
        if (match.open_seat()) return {};
        return refuse(RejectCode::kMatchFull, "Both seats of this match are taken.");
    }

    Answer operator()(const WatchMatch&) const {
        if (match.spectators() < max_spectators) return {};
        return refuse(RejectCode::kSpectatorsFull,
                      "This match has as many spectators as it may have.");
    }

    Answer operator()(const Resume& command) const {
        if (!match.seats_of(hash_token(command.token)).empty()) return {};
        return refuse(RejectCode::kBadToken, "The token holds no seat in this match.");
    }

    Answer operator()(const TakeSeat& command) const {
        if (!match.holder(command.seat)) return {};
        return refuse(RejectCode::kSeatTaken, "That seat is taken.");
    }

    Answer operator()(const LeaveSeat& command) const {
        if (Answer answer = holds(command.seat)) return answer;
        return may_free_seat();
    }

    Answer operator()(const Leave&) const {
        if (match.seats_of(member).empty()) return {};
        return may_free_seat();
    }

    Answer operator()(const Aim& command) const { return may_act(command.seat); }

    Answer operator()(const PlaceCueBall& command) const {
        if (Answer answer = may_act(command.seat)) return answer;
        GameState trial = match.game();
        if (const auto illegal = match.rules().place_cue_ball(trial, command.position))
            return refuse(*illegal);
        return {};
    }

    Answer operator()(const Shoot& command) const {
        if (Answer answer = may_act(command.seat)) return answer;
        if (const auto illegal = match.rules().check_shot(match.game(), {command.direction}))
            return refuse(*illegal);
        return {};
    }

    Answer operator()(const Rematch& command) const {
        if (Answer answer = holds(command.seat)) return answer;
        return in_phase(Phase::kOver);
    }
};

}  // namespace

std::optional<Refusal> check(const CreateMatch& command) {
    const Ruleset* rules = find_ruleset(command.game);
    if (!rules) return refuse(RejectCode::kUnknownGame, "There is no game of this name.");
    const auto fault = poolhall::check(*rules, command.settings.value_or(GameSettings{}));
    if (!fault) return {};
    return refuse(RejectCode::kBadField, "field /settings" + fault->pointer + " " + fault->reason);
}

std::optional<Refusal> check(const Match& match, MemberId member, const ClientBody& command,
                             std::uint32_t max_spectators) {
    return std::visit(Checks{match, member, max_spectators}, command);
}

}  // namespace poolhall::server
