#pragma once

#include "protocol/messages.hpp"
#include "shared/enum_names.hpp"

// The names of the enumerators of messages.hpp; the simulation's stand beside its enumerations.
namespace poolhall::protocol {

constexpr auto enum_names(Stream /*type*/) {
    return names_of<Stream>({{Stream::kStates, "states"}, {Stream::kShots, "shots"}});
}

constexpr auto enum_names(Phase /*type*/) {
    return names_of<Phase>({{Phase::kWaiting, "waiting"},
                            {Phase::kAiming, "aiming"},
                            {Phase::kPlaying, "playing"},
                            {Phase::kOver, "over"}});
}

constexpr auto enum_names(RejectCode /*type*/) {
    return names_of<RejectCode>({{RejectCode::kMalformed, "malformed"},
                                 {RejectCode::kUnknownType, "unknown_type"},
                                 {RejectCode::kMissingField, "missing_field"},
                                 {RejectCode::kUnknownField, "unknown_field"},
                                 {RejectCode::kBadField, "bad_field"},
                                 {RejectCode::kStaleSeq, "stale_seq"},
                                 {RejectCode::kNotInMatch, "not_in_match"},
                                 {RejectCode::kAlreadyInMatch, "already_in_match"},
                                 {RejectCode::kUnknownMatch, "unknown_match"},
                                 {RejectCode::kUnknownGame, "unknown_game"},
                                 {RejectCode::kBadToken, "bad_token"},
                                 {RejectCode::kMatchFull, "match_full"},
                                 {RejectCode::kSpectatorsFull, "spectators_full"},
                                 {RejectCode::kNotYourSeat, "not_your_seat"},
                                 {RejectCode::kSeatTaken, "seat_taken"},
                                 {RejectCode::kNotYourTurn, "not_your_turn"},
                                 {RejectCode::kWrongPhase, "wrong_phase"},
                                 {RejectCode::kIllegal, "illegal"},
                                 {RejectCode::kServerFull, "server_full"},
                                 {RejectCode::kShuttingDown, "shutting_down"},
                                 {RejectCode::kStorage, "storage"}});
}

}  // namespace poolhall::protocol
