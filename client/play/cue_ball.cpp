#include "client/play/cue_ball.hpp"

#include "shared/game/ruleset.hpp"

namespace poolhall::client {
namespace {

Vec2 placed_at(const GameState& state) {
    return xy(state.scene.balls[state.cue_ball.value].state.r);
}

}  // namespace

Vec2 cue_ball_of(const protocol::TableState& table) {
    return table.cue.value_or(placed_at(table.state));
}

std::optional<Vec2> unplaced_cue_ball(const protocol::TableState& table) {
    return table.cue == placed_at(table.state) ? std::nullopt : table.cue;
}

GameState shown_state(const protocol::TableState& table) {
    GameState state = table.state;
    set_xy(state.scene.balls[state.cue_ball.value].state.r, cue_ball_of(table));
    return state;
}

bool hold_cue_ball(protocol::TableState& table, Vec2 position) {
    if (!table.legal.place) return false;
    const Vec2 place = nearest_place(*table.legal.place, position);
    if (place == cue_ball_of(table)) return false;
    table.cue = place;
    if (const Ruleset* rules = find_ruleset(table.game))
        table.aim = rules->legal(shown_state(table)).aim;
    return true;
}

}  // namespace poolhall::client
