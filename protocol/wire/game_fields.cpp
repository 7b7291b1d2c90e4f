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

bool LegalCodec::read(const Cursor& cursor, Legal& legal) const {
    if (!read_fields(cursor, legal)) return false;
    if (legal.place &&
        (legal.place->low.x > legal.place->high.x || legal.place->low.y > legal.place->high.y))
        return cursor.refuse_at("/place/high", "must not be below low");
    if (!legal.shoot) return true;
    const StrokeBounds& bounds = *legal.shoot;
    if (bounds.max_speed < bounds.min_speed)
        return cursor.refuse_at("/shoot/max_speed", "must not be below min_speed");
    if (bounds.own_speed < bounds.min_speed || bounds.own_speed > bounds.max_speed)
        return cursor.refuse_at("/shoot/own_speed", "must be from min_speed to max_speed");
    return true;
}

Json LegalCodec::write(const Legal& legal, Encoding encoding) const {
    return Object<Legal>{}.write(legal, encoding);
}

}  // namespace poolhall::protocol::wire
