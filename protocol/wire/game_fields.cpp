#include "protocol/wire/game_fields.hpp"

namespace poolhall::protocol::wire {

bool GameStateCodec::read(const Cursor& cursor, GameState& state) const {
    if (!read_fields(cursor, state)) return false;
    if (state.scene.strike) return cursor.refuse_at("/scene/strike", "must not be there at rest");
    if (state.cue_ball.value >= state.scene.balls.size())
        return cursor.refuse_at("/cue_ball", "must be the index of a ball of the scene");
    if (state.winner && !state.over)
        return cursor.refuse_at("/winner", "must not be there before the game is over");
    return true;
}

Json GameStateCodec::write(const GameState& state, Encoding encoding) const {
    return Object<GameState>{}.write(state, encoding);
}

}  // namespace poolhall::protocol::wire
