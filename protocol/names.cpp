#include "protocol/encoding.hpp"
#include "protocol/limits.hpp"
#include "protocol/messages.hpp"
#include "protocol/wire/enums.hpp"

namespace poolhall::protocol {

std::optional<Encoding> encoding_of(std::string_view subprotocol) {
    if (subprotocol == kSubprotocolJson) return Encoding::kJson;
    if (subprotocol == kSubprotocolCbor) return Encoding::kCbor;
    return std::nullopt;
}

std::string_view name(Phase phase) {
    switch (phase) {
        case Phase::kWaiting:
            return "waiting";
        case Phase::kAiming:
            return "aiming";
        case Phase::kPlaying:
            return "playing";
        case Phase::kOver:
            return "over";
    }
    return {};
}

std::string_view name(RejectCode code) {
    switch (code) {
        case RejectCode::kMalformed:
            return "malformed";
        case RejectCode::kUnknownType:
            return "unknown_type";
        case RejectCode::kMissingField:
            return "missing_field";
        case RejectCode::kUnknownField:
            return "unknown_field";
        case RejectCode::kBadField:
            return "bad_field";
        case RejectCode::kStaleSeq:
            return "stale_seq";
        case RejectCode::kNotInMatch:
            return "not_in_match";
        case RejectCode::kAlreadyInMatch:
            return "already_in_match";
        case RejectCode::kUnknownMatch:
            return "unknown_match";
        case RejectCode::kUnknownGame:
            return "unknown_game";
        case RejectCode::kBadToken:
            return "bad_token";
        case RejectCode::kMatchFull:
            return "match_full";
        case RejectCode::kSpectatorsFull:
            return "spectators_full";
        case RejectCode::kNotYourSeat:
            return "not_your_seat";
        case RejectCode::kSeatTaken:
            return "seat_taken";
        case RejectCode::kNotYourTurn:
            return "not_your_turn";
        case RejectCode::kWrongPhase:
            return "wrong_phase";
        case RejectCode::kIllegal:
            return "illegal";
        case RejectCode::kServerFull:
            return "server_full";
        case RejectCode::kShuttingDown:
            return "shutting_down";
        case RejectCode::kStorage:
            return "storage";
    }
    return {};
}

std::string_view name(Stream stream) {
    switch (stream) {
        case Stream::kStates:
            return "states";
        case Stream::kShots:
            return "shots";
    }
    return {};
}

}  // namespace poolhall::protocol

namespace poolhall::protocol::wire {

std::string_view name(PocketModel model) {
    switch (model) {
        case PocketModel::kNone:
            return "none";
        case PocketModel::kEndGame:
            return "end_game";
        case PocketModel::kPool:
            return "pool";
        case PocketModel::kCircles:
            break;
    }
    return {};
}

std::string_view name(BallBallModel model) {
    switch (model) {
        case BallBallModel::kElastic:
            return "elastic";
        case BallBallModel::kRestitution:
            return "restitution";
        case BallBallModel::kFriction:
            return "friction";
    }
    return {};
}

std::string_view name(RailModel model) {
    switch (model) {
        case RailModel::kElastic:
            return "elastic";
        case RailModel::kRestitution:
            return "restitution";
        case RailModel::kHan2005:
            return "han2005";
        case RailModel::kMathavan2010:
            return "mathavan2010";
        case RailModel::kMathavan2010Fast:
            return "mathavan2010_fast";
    }
    return {};
}

}  // namespace poolhall::protocol::wire
