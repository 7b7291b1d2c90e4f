#include "client/play/shown_table.hpp"

#include "client/play/cue_ball.hpp"
#include "client/play/overlays.hpp"

#include <utility>

namespace poolhall::client {
namespace {

std::vector<BallView> balls_at(const Shot& shot, double t) {
    std::vector<BallView> balls;
    balls.reserve(shot.scene.balls.size());
    for (std::size_t i = 0; i < shot.scene.balls.size(); ++i) {
        const BallIndex ball{static_cast<std::uint16_t>(i)};
        balls.push_back(
            {shot.scene.balls[i].id, shot.timeline.position(ball, t), shot.timeline.sunk(ball, t)});
    }
    return balls;
}

}  // namespace

void ShownTable::pass(const Playback::Passed& passed) {
    if (std::holds_alternative<Playback::ShotBegan>(passed)) finished_.reset();
    if (const auto* end = std::get_if<Playback::ShotFinished>(&passed)) finished_ = end->shot;
}

bool ShownTable::refresh() {
    hold_back();
    const bool had_result = std::exchange(has_result_, result().has_value());
    return has_result_ != had_result;
}

void ShownTable::hold_back() {
    const auto& newest = match_.info().table;
    if (playback_.idle() || !held_ || !newest) {
        held_ = newest;
        return;
    }
    // Who is there does not wait for the balls; score and turn do.
    held_->spectators = newest->spectators;
    for (std::size_t i = 0; i < kSeatCount; ++i) {
        held_->seats[i].taken = newest->seats[i].taken;
        held_->seats[i].connected = newest->seats[i].connected;
        held_->seats[i].name = newest->seats[i].name;
    }
}

std::optional<Seat> ShownTable::acting_seat() const {
    const MatchInfo& info = match_.info();
    const bool linked = info.link == Link::kOnline || info.link == Link::kOffline;
    return at_rest() && linked ? info.acting_seat() : std::nullopt;
}

std::vector<BallView> ShownTable::balls() const {
    if (const Shot* shot = playback_.shot()) return balls_at(*shot, playback_.time());
    const auto& table = match_.info().table;
    if (!table) return {};
    // A game that is over has cleared its table for the next one; the sunk balls stay in sight
    // until it begins.
    if (table->phase == protocol::Phase::kOver && finished_ && finished_->number == table->shot)
        return balls_at(*finished_, finished_->timeline.known_until());
    std::vector<BallView> balls;
    for (const SceneBall& ball : shown_state(*table).scene.balls)
        balls.push_back({ball.id, xy(ball.state.r), false});
    return balls;
}

std::vector<CollisionMark> ShownTable::collision_marks() const {
    if (!collision_mode_) return {};
    if (const Shot* shot = playback_.shot())
        return client::collision_marks(shot->timeline, playback_.time());
    if (!finished_) return {};
    return client::collision_marks(finished_->timeline, finished_->timeline.known_until());
}

bool ShownTable::cue_ball_is_down() const {
    const Shot* shot = playback_.shot();
    return shot != nullptr && shot->cue_ball.value < shot->timeline.ball_count() &&
           shot->timeline.sunk(shot->cue_ball, playback_.time());
}

std::optional<Ruling> ShownTable::result() const {
    std::optional<Ruling> ruling = playback_.ruling();
    const auto& table = match_.info().table;
    if (at_rest() && table && table->phase == protocol::Phase::kOver) ruling = table->ruling;
    return ruling && ruling->winner ? ruling : std::nullopt;
}

}  // namespace poolhall::client
