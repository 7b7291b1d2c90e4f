#include "client/play/match.hpp"

namespace poolhall::client {

std::optional<Seat> MatchInfo::acting_seat() const {
    if (!table || table->phase != protocol::Phase::kAiming || !mine[table->turn.value]) {
        return std::nullopt;
    }
    return table->turn;
}

GameState game_state_of(const protocol::TableState& table) {
    GameState state;
    state.scene = table.scene;
    state.cue_ball = table.cue_ball;
    state.turn = table.turn;
    state.shots = table.may_place ? 0 : 1;
    state.over = table.phase == protocol::Phase::kOver;
    if (state.over && table.ruling) state.winner = table.ruling->winner;
    return state;
}

}  // namespace poolhall::client
