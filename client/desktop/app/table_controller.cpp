#include "client/desktop/app/table_controller.hpp"

#include "client/play/cue_ball.hpp"
#include "client/play/isolated.hpp"
#include "client/play/words.hpp"
#include "protocol/text.hpp"
#include "shared/game/ruleset.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace poolhall::client {
namespace {

/// Counterclockwise. A direction for display and for the server to take as it is: its last bits
/// need not be the same on every machine.
Vec2 rotated(Vec2 direction, double angle) {
    const Vec2 unit = normalized(direction);
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {c * unit.x - s * unit.y, s * unit.x + c * unit.y};
}

}  // namespace

TableController::TableController(ClientMatch& match, Playback& playback)
    : match_(match), playback_(playback), shown_(match, playback), placing_(match) {
    refresh();
}

void TableController::act(Action action) {
    ++revision_;
    switch (action) {
        case Action::kStepMode:
            step_mode_.toggle();
            trail_.clear();
            break;
        case Action::kCollisionMode:
            shown_.toggle_collision_marks();
            break;
        case Action::kSolvers:
            solvers_.cycle();
            show_status(solvers_.description());
            break;
        case Action::kHotSeat:
            match_.toggle_hot_seat();
            break;
        case Action::kGo:
            go();
            break;
        case Action::kExit:
        case Action::kFrameRate:
        case Action::kMute:
        case Action::kScreenshot:
        case Action::kCopyCode:
            break;
    }
}

void TableController::go() {
    if (match_.info().link == Link::kLost || match_.info().link == Link::kConnecting) {
        match_.retry_now();
    } else if (step_mode_.on() && !playback_.idle()) {
        take_step();
        step_mode_.looked(now_, playback_.idle() && !shown_.result());
    } else if (step_mode_.takes(now_)) {
        return;
    } else if (shown_.result()) {
        match_.make(Agree{Accord::kRematch});
        step_mode_.looked(now_, false);
    } else if (acting()) {
        match_.make(Shoot{{.direction = match_.info().table->aim}});
    }
}

void TableController::take_step() {
    const Shot* shot = playback_.shot();
    const std::uint32_t number = shot->number;
    std::vector<Vec2> before;
    for (const BallView& ball : shown_.balls())
        before.push_back(ball.r);
    if (!playback_.step()) {
        show_status("The next step has not been received yet");
        return;
    }
    take_passed();
    refresh();
    std::vector<Vec2> after;
    for (const BallView& ball : shown_.balls())
        after.push_back(ball.r);
    const bool same_shot = playback_.idle() || playback_.shot()->number == number;
    if (same_shot) trail_.step(before, after);
}

void TableController::update(double dt, double now, const Steering& steering) {
    now_ = now;
    match_.poll(now);
    if (std::string notice = match_.take_notice(); !notice.empty()) show_status(std::move(notice));
    if (!status_.empty() && now_ >= status_until_) {
        status_.clear();
        ++revision_;
    }
    advance(dt);
    if (solvers_.poll()) ++revision_;
    refresh();
    pause_before_new_game();
    if (seconds_left() != std::exchange(seconds_shown_, seconds_left())) ++revision_;
    steer(dt, steering);
}

void TableController::advance(double dt) {
    if (!playback_.idle() && !step_mode_.on()) {
        playback_.advance(dt);
        ++revision_;
    }
    take_passed();
}

void TableController::take_passed() {
    for (const auto& passed : playback_.take_passed()) {
        shown_.pass(passed);
        if (const auto* event = std::get_if<ShotEvent>(&passed)) sounds_.emplace_back(*event);
        if (const auto* end = std::get_if<Playback::ShotFinished>(&passed))
            solvers_.follow(end->shot);
    }
    if (const Shot* shot = playback_.shot()) solvers_.follow(*shot);
}

bool TableController::at_end_of_shot() const {
    return step_mode_.at_end() && playback_.idle();
}

bool TableController::acting() const {
    return shown_.acting_seat() && !at_end_of_shot();
}

void TableController::refresh() {
    if (!shown_.refresh()) return;
    ++revision_;
    const auto result = shown_.result();
    if (result) sounds_.emplace_back(GameEnded{tone_of(*result, match_.info())});
    ended_at_ = result ? std::optional(now_) : std::nullopt;
}

void TableController::pause_before_new_game() {
    // In step mode time stands still, and a game that has ended can be looked at for as long as one
    // likes.
    if (!ended_at_) return;
    if (step_mode_.on()) ended_at_ = now_;
    if (practice() && now_ - *ended_at_ >= kNewGamePause) match_.make(Agree{Accord::kRematch});
}

void TableController::steer(double dt, const Steering& steering) {
    if (steering.idle() || !acting()) return;
    if (steering.slide != 0) match_.hold_cue_ball(cue_ball() + Vec2{0, steering.slide * dt});
    if (steering.turn != 0) match_.aim(rotated(match_.info().table->aim, steering.turn * dt));
}

void TableController::pointer_moved(Vec2 r) {
    if (!acting()) return;
    if (placing_.dragging()) {
        placing_.drag(r);
    } else {
        aim_at(r);
    }
}

void TableController::pointer_pressed(Vec2 r) {
    if (at_end_of_shot()) {
        step_mode_.leave_end();
        ++revision_;
        return;
    }
    if (!acting()) return;
    if (!placing_.take_up(r)) match_.make(Shoot{{.direction = match_.info().table->aim}});
}

void TableController::pointer_released() {
    placing_.let_go();
}

void TableController::aim_at(Vec2 r) {
    const Vec2 direction = r - cue_ball();
    // From within the ball the aim would spin about with the smallest move.
    if (norm(direction) > match_.info().table->state.scene.ball.radius)
        match_.aim(normalized(direction));
}

void TableController::show_status(std::string line) {
    status_ = std::move(line);
    status_until_ = now_ + kStatusTime;
    ++revision_;
}

std::vector<TableSound> TableController::take_sounds() {
    return std::exchange(sounds_, {});
}

bool TableController::animated() const {
    return solvers_.pending() || (!playback_.idle() && !step_mode_.on());
}

Vec2 TableController::cue_ball() const {
    return cue_ball_of(*match_.info().table);
}

ViewState TableController::view(std::optional<double> frames_per_second) const {
    const MatchInfo& info = match_.info();
    ViewState view;
    if (const auto& table = shown_.table()) {
        view.table = table->state.scene.table;
        view.ball_radius = table->state.scene.ball.radius;
        if (acting()) view.placement = table->legal.place;
    } else {
        view.table = all_rulesets().front()->new_game(Seat{0}).scene.table;
    }
    view.balls = shown_.balls();
    view.aim = aim_view();
    view.trail = trail_.rings();
    view.marks = shown_.collision_marks();
    view.solvers = solver_views();
    view.match = match_view();
    view.banner = banner(info, shown_);
    view.frames_per_second = frames_per_second;
    if (frames_per_second || has_own_physics(info)) view.physics = physics_of(info);
    view.status = status_;
    view.hint = at_end_of_shot() ? "End of the shot. Space again: back to the table"
                                 : hint(info, shown_, step_mode_.on());
    view.step_mode = step_mode_.on();
    view.collision_mode = shown_.collision_mode();
    return view;
}

std::optional<AimView> TableController::aim_view() const {
    const auto& table = shown_.table();
    if (!table || !shown_.at_rest() || at_end_of_shot() || table->phase != protocol::Phase::kAiming)
        return std::nullopt;
    if (table->aim == Vec2{}) return std::nullopt;
    return AimView{cue_ball(), table->aim,
                   predict(shown_state(*table).scene, table->state.cue_ball, table->aim)};
}

std::vector<SolverView> TableController::solver_views() const {
    const Shot* shot = playback_.shot();
    const bool shown = shot != nullptr && shot->number == solvers_.shot();
    return solvers_.view(shown ? playback_.time() : std::numeric_limits<double>::infinity());
}

std::optional<std::uint32_t> TableController::seconds_left() const {
    const auto& ends = match_.info().clock_ends;
    if (!ends || !shown_.at_rest()) return std::nullopt;
    return static_cast<std::uint32_t>(std::ceil(std::max(0.0, *ends - now_)));
}

MatchView TableController::match_view() const {
    const MatchInfo& info = match_.info();
    MatchView view;
    view.link = info.link;
    view.round_trip_ms = info.round_trip_ms;
    const auto& table = shown_.table();
    if (!table) return view;
    view.code = practice() ? "" : protocol::spoken_code(table->code);
    view.spectators = table->spectators;
    const bool has_turn =
        table->phase == protocol::Phase::kAiming || table->phase == protocol::Phase::kPlaying;
    if (has_turn) view.turn = table->legal.seat;
    view.seconds_left = seconds_left();
    for (std::size_t i = 0; i < kSeatCount; ++i) {
        const auto& seat = table->seats[i];
        view.seats[i] = {seat.taken ? isolated(seat.name) : "", seat.connected, info.mine[i],
                         seat.wants_rematch, seat.wins};
    }
    return view;
}

}  // namespace poolhall::client
