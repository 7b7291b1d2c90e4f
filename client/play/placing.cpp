#include "client/play/placing.hpp"

#include "client/play/cue_ball.hpp"

namespace poolhall::client {

bool Placing::take_up(Vec2 r) {
    const MatchInfo& info = match_.info();
    dragging_ = info.acting_seat() && info.table->legal.place &&
                norm(r - cue_ball_of(*info.table)) <= info.table->state.scene.ball.radius;
    return dragging_;
}

void Placing::drag(Vec2 r) {
    if (dragging_) match_.hold_cue_ball(r);
}

}  // namespace poolhall::client
