#include "client/play/practice_match.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace poolhall::client {
namespace {

/// The whole shot as the playback wants it.
Shot played_shot(std::uint32_t number, const ShotOutcome& outcome, BallIndex cue_ball) {
    const ShotTrace& trace = outcome.trace;
    ShotTimeline timeline(positions_of(outcome.scene));
    std::size_t event = 0;
    std::vector<ShotTimeline::Moved> moved(trace.balls.size());
    // A shot that is over at once has one sample only, and events all the same.
    const std::size_t last = std::max<std::size_t>(trace.sample_count(), 2) - 1;
    for (std::size_t k = 1; k <= last; ++k) {
        const double t = static_cast<double>(k) / trace.sample_hz;
        const std::size_t first = event;
        while (event < trace.events.size() && trace.events[event].t <= t)
            ++event;
        for (std::size_t i = 0; i < moved.size(); ++i) {
            moved[i] = {BallIndex{static_cast<std::uint16_t>(i)},
                        xy(trace.sample(std::min(k, trace.sample_count() - 1), i))};
        }
        timeline.extend(t, std::span(trace.events).subspan(first, event - first), moved);
    }
    timeline.finish(trace.duration, trace.balls);
    return {number, outcome.scene, cue_ball, std::move(timeline), outcome.ruling};
}

}  // namespace

PracticeMatch::PracticeMatch(const Ruleset& rules, std::string player, Playback& playback,
                             GameSettings settings)
    : rules_(rules),
      settings_(std::move(settings)),
      playback_(playback),
      state_(new_game(rules_, kPlayer, settings_)) {
    auto& table = info_.table.emplace();
    table.game = rules.name;
    table.seats[kPlayer.value] = {true, true, std::move(player), false, 0};
    table.seats[kHouse.value] = {true, true, "The house", false, 0};
    info_.mine[kPlayer.value] = true;
    show_state();
}

void PracticeMatch::poll(double /*now*/) {}

double PracticeMatch::due_in(double /*now*/) const {
    return std::numeric_limits<double>::infinity();
}

std::string PracticeMatch::take_notice() {
    return std::exchange(notice_, {});
}

void PracticeMatch::aim(Vec2 direction) {
    if (!info_.acting_seat()) return;
    info_.table->aim = direction;
    ++info_.revision;
}

void PracticeMatch::place_cue_ball(Vec2 position) {
    if (rules_.place_cue_ball(state_, position)) return;
    show_state();
}

void PracticeMatch::shoot(Vec2 direction) {
    const ShotCommand command{direction};
    if (rules_.check_shot(state_, command)) return;
    const BallIndex cue_ball = state_.cue_ball;
    ShotOutcome outcome = rules_.play(state_, command);
    auto& table = *info_.table;
    info_.kernel = outcome.trace.kernel;
    playback_.begin(played_shot(table.shot + 1, outcome, cue_ball));
    table.ruling = outcome.ruling;
    table.shot += 1;
    if (outcome.ruling.winner) table.seats[outcome.ruling.winner->value].wins += 1;
    state_ = std::move(outcome.state);
    state_.turn = kPlayer;
    show_state();
}

void PracticeMatch::ask_new_game() {
    if (!state_.over) return;
    playback_.clear();
    state_ = new_game(rules_, kPlayer, settings_);
    info_.table->game_number += 1;
    info_.table->ruling.reset();
    show_state();
}

void PracticeMatch::toggle_hot_seat() {
    notice_ = "Practice has one seat only";
}

void PracticeMatch::retry_now() {}

void PracticeMatch::show_state() {
    auto& table = *info_.table;
    table.phase = state_.over ? protocol::Phase::kOver : protocol::Phase::kAiming;
    table.turn = state_.turn;
    table.scene = state_.scene;
    table.cue_ball = state_.cue_ball;
    table.may_place = !state_.over && rules_.nearest_placement(state_, Vec2{}).has_value();
    if (!state_.over) table.aim = rules_.default_aim(state_);
    ++info_.revision;
}

}  // namespace poolhall::client
