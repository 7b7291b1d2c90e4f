#include "client/play/local_match.hpp"

#include "client/play/cue_ball.hpp"
#include "client/play/words.hpp"
#include "shared/analysis/effect_use.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace poolhall::client {
namespace {

bool begins_game(const MatchEvent& event) {
    return std::holds_alternative<GameBegan>(event);
}

}  // namespace

LocalMatch::LocalMatch(const MatchSpec& spec, const PerSeat<std::string>& names, Playback& playback)
    : core_(spec), playback_(playback) {
    const bool alone = spec.settings.turns == Turns::kSolo;
    info_.mine = {true, !alone};
    auto& table = info_.table.emplace();
    table.game = spec.rules->name;
    if (spec.settings != MatchSettings{}) table.settings = spec.settings;
    for (const Seat seat : kSeats)
        table.seats[seat.value] = {true, true, names[seat.value], false, 0};
    show_position();
}

void LocalMatch::poll(double now) {
    now_ = now;
    const auto end = core_.clock_ends_ms();
    if (!end) {
        core_.start_clock(now_ms());
    } else if (now_ms() >= *end) {
        play(core_.now().legal.seat, TimeOut{});
    }
    show_clock();
}

double LocalMatch::due_in(double now) const {
    const auto end = core_.clock_ends_ms();
    if (!end) return std::numeric_limits<double>::infinity();
    return std::max(0.0, static_cast<double>(*end) / 1000 - now);
}

std::string LocalMatch::take_notice() {
    return std::exchange(notice_, {});
}

void LocalMatch::aim(Vec2 direction) {
    if (!info_.acting_seat()) return;
    info_.table->aim = direction;
    ++info_.revision;
}

void LocalMatch::hold_cue_ball(Vec2 position) {
    if (!info_.acting_seat()) return;
    if (client::hold_cue_ball(*info_.table, position)) ++info_.revision;
}

void LocalMatch::make(const Move& move) {
    for (const Seat seat : movers(info_, move)) {
        const auto held = unplaced_cue_ball(*info_.table);
        if (held && std::holds_alternative<Shoot>(move)) play(seat, Place{*held});
        play(seat, move);
    }
}

void LocalMatch::play(Seat seat, const Move& move) {
    if (!core_.find_fault(seat, move, now_ms())) take(core_.play(seat, move, now_ms()));
}

void LocalMatch::take(MatchStep step) {
    double shown_for = 0;
    if (const ShotTaken* taken = step.shot()) {
        const SimulatedShot& shot = taken->simulated;
        playback_.begin(
            {taken->shot, shot.scene, core_.now().game.cue_ball, timeline_of(shot), step.ruling()});
        info_.kernel = shot.trace.kernel;
        info_.effects = analysis::effect_uses(shot.scene, shot.trace);
        shown_for = shot.trace.duration;
    }
    if (std::any_of(step.events.begin(), step.events.end(), begins_game)) playback_.clear();
    const auto ruling = step.ruling();
    if (ruling && ruling->verdict == Verdict::kTimedOut) {
        notice_ = ruling_sentence(*ruling, info_);
    }
    core_.commit(std::move(step), now_ms() + static_cast<std::int64_t>(1000 * shown_for));
    show_position();
}

void LocalMatch::show_clock() {
    info_.clock_ends.reset();
    if (const auto end = core_.clock_ends_ms()) info_.clock_ends = 1e-3 * static_cast<double>(*end);
}

void LocalMatch::toggle_hot_seat() {
    notice_ = info_.hot_seat() ? "Both seats are played here" : "Practice has one seat only";
}

void LocalMatch::retry_now() {}

void LocalMatch::show_position() {
    const Position& now = core_.now();
    auto& table = *info_.table;
    table.phase = now.game.over ? protocol::Phase::kOver : protocol::Phase::kAiming;
    table.game_number = now.game_number;
    table.shot = now.shots;
    for (const Seat seat : kSeats) {
        table.seats[seat.value].wants_rematch = now.consents[seat.value];
        table.seats[seat.value].wins = now.wins[seat.value];
    }
    table.state = now.game;
    table.legal = now.legal;
    if (!now.game.over) table.aim = now.legal.aim;
    table.cue.reset();
    table.ruling = now.ruling;
    table.winner = now.winner;
    ++info_.revision;
}

std::int64_t LocalMatch::now_ms() const {
    return static_cast<std::int64_t>(1000 * now_);
}

MatchSpec practice_spec(const Ruleset& rules, const GameSettings& settings) {
    return {&rules, Seat{0}, {.game = settings, .turns = Turns::kSolo}};
}

}  // namespace poolhall::client
