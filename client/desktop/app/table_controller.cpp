#include "client/desktop/app/table_controller.hpp"

#include "client/play/isolated.hpp"
#include "client/play/remote_match.hpp"
#include "client/play/words.hpp"
#include "shared/game/end_game.hpp"

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

TableController::TableController(Match& match, Playback& playback)
    : match_(match), playback_(playback), shown_(match, playback) {
    shown_.refresh();
}

void TableController::act(Action action) {
    ++revision_;
    switch (action) {
        case Action::kStepMode:
            step_mode_.toggle();
            trail_.clear();
            break;
        case Action::kCollisionMode:
            marks_.toggle();
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
        match_.ask_new_game();
        step_mode_.looked(now_, false);
    } else if (acting()) {
        match_.shoot(match_.info().table->aim);
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
    shown_.refresh();
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
    shown_.refresh();
    announce_result();
    pause_before_new_game();
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
        marks_.pass(passed);
        if (const auto* event = std::get_if<ShotEvent>(&passed)) heard_.emplace_back(*event);
        if (const auto* end = std::get_if<Playback::ShotFinished>(&passed)) finish(end->shot);
    }
    if (const Shot* shot = playback_.shot()) solvers_.follow(*shot);
}

void TableController::finish(const Shot& shot) {
    shown_.shot_finished(shot);
    solvers_.follow(shot);
}

bool TableController::at_end_of_shot() const {
    return step_mode_.at_end() && playback_.idle();
}

bool TableController::acting() const {
    return shown_.acting_seat() && !at_end_of_shot();
}

void TableController::announce_result() {
    const auto result = shown_.result();
    if (result.has_value() == ended_at_.has_value()) return;
    if (result) heard_.emplace_back(GameEnded{tone_of(*result, match_.info())});
    ended_at_ = result ? std::optional(now_) : std::nullopt;
    ++revision_;
}

void TableController::pause_before_new_game() {
    // In step mode time stands still, and a game that has ended can be looked at for as long as one
    // likes.
    if (!ended_at_) return;
    if (step_mode_.on()) ended_at_ = now_;
    if (practice() && now_ - *ended_at_ >= kNewGamePause) match_.ask_new_game();
}

void TableController::steer(double dt, const Steering& steering) {
    if (steering.idle() || !acting()) return;
    if (steering.slide != 0) place_cue_ball(cue_ball() + Vec2{0, steering.slide * dt});
    if (steering.turn != 0) match_.aim(rotated(match_.info().table->aim, steering.turn * dt));
}

void TableController::place_cue_ball(Vec2 position) {
    const auto& table = *match_.info().table;
    const Ruleset* rules = find_ruleset(table.game);
    if (!table.may_place || rules == nullptr) return;
    const auto place = rules->nearest_placement(game_state_of(table), position);
    if (place && *place != cue_ball()) match_.place_cue_ball(*place);
}

void TableController::pointer_moved(Vec2 r) {
    if (!acting()) return;
    if (dragging_) {
        place_cue_ball(r);
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
    const auto& table = *match_.info().table;
    const bool on_cue_ball = norm(r - cue_ball()) <= table.scene.ball.radius;
    dragging_ = on_cue_ball && table.may_place;
    if (!dragging_) match_.shoot(table.aim);
}

void TableController::pointer_released() {
    dragging_ = false;
}

void TableController::aim_at(Vec2 r) {
    const Vec2 direction = r - cue_ball();
    // From within the ball the aim would spin about with the smallest move.
    if (norm(direction) > match_.info().table->scene.ball.radius) match_.aim(normalized(direction));
}

void TableController::show_status(std::string line) {
    status_ = std::move(line);
    status_until_ = now_ + kStatusTime;
    ++revision_;
}

std::vector<Heard> TableController::take_heard() {
    return std::exchange(heard_, {});
}

bool TableController::animated() const {
    return solvers_.pending() || (!playback_.idle() && !step_mode_.on());
}

Vec2 TableController::cue_ball() const {
    const auto& table = *match_.info().table;
    return xy(table.scene.balls[table.cue_ball.value].state.r);
}

ViewState TableController::view(std::optional<double> frames_per_second) const {
    const MatchInfo& info = match_.info();
    ViewState view;
    view.table = {end_game::kLength, end_game::kWidth, true, PocketModel::kEndGame};
    if (const auto& table = shown_.table()) {
        view.table = table->scene.table;
        view.ball_radius = table->scene.ball.radius;
        if (acting() && table->may_place) view.base_line_x = cue_ball().x;
    }
    view.balls = shown_.balls();
    view.aim = aim_view();
    view.trail = trail_.rings();
    if (marks_.shown()) view.marks = marks_.marks();
    view.solvers = solver_views();
    view.match = match_view();
    view.banner = banner(info, shown_);
    view.frames_per_second = frames_per_second;
    if (frames_per_second || has_own_physics(info)) view.physics = physics_of(info);
    view.status = status_;
    view.hint = at_end_of_shot() ? "End of the shot. Space again: back to the table"
                                 : hint(info, shown_, step_mode_.on());
    view.step_mode = step_mode_.on();
    view.collision_mode = marks_.shown();
    return view;
}

std::optional<AimView> TableController::aim_view() const {
    const auto& table = shown_.table();
    if (!table || !shown_.at_rest() || at_end_of_shot() || table->phase != protocol::Phase::kAiming)
        return std::nullopt;
    if (table->aim == Vec2{}) return std::nullopt;
    return AimView{cue_ball(), table->aim, predict(table->scene, table->cue_ball, table->aim)};
}

std::vector<SolverView> TableController::solver_views() const {
    const Shot* shot = playback_.shot();
    const bool shown = shot != nullptr && shot->number == solvers_.shot();
    return solvers_.view(shown ? playback_.time() : std::numeric_limits<double>::infinity());
}

MatchView TableController::match_view() const {
    const MatchInfo& info = match_.info();
    MatchView view;
    view.link = info.link;
    view.round_trip_ms = info.round_trip_ms;
    const auto& table = shown_.table();
    if (!table) return view;
    view.code = practice() ? "" : shown_code(table->code);
    view.spectators = table->spectators;
    const bool has_turn =
        table->phase == protocol::Phase::kAiming || table->phase == protocol::Phase::kPlaying;
    if (has_turn) view.turn = table->turn;
    for (std::size_t i = 0; i < kSeatCount; ++i) {
        const auto& seat = table->seats[i];
        view.seats[i] = {seat.taken ? isolated(seat.name) : "", seat.connected, info.mine[i],
                         seat.wants_rematch, seat.wins};
    }
    return view;
}

}  // namespace poolhall::client
