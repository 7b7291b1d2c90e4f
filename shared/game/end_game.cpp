#include "shared/game/end_game.hpp"

#include "shared/game/resting.hpp"
#include "shared/physics/simulate.hpp"

#include <algorithm>
#include <cassert>

namespace poolhall {

namespace {

using namespace end_game;

GameState new_game(Seat first) {
    GameState state;
    state.scene.id = "end_game";
    state.scene.table = {kLength, kWidth, true, PocketModel::kEndGame};
    state.scene.effects.linear_drag = LinearDragSpec{kDrag, kStopSpeed};
    state.scene.solver = {SolverKind::kEuler, kPlayoutHz};
    state.scene.balls = {{std::string(kCueBallId), {{kBaseLineX, 0, 0}, {}, {}}},
                         {std::string(kEightBallId), {{kFootSpotX, 0, 0}, {}, {}}}};
    state.turn = first;
    return state;
}

Vec2 cue_ball_of(const GameState& state) {
    return xy(state.scene.balls[state.cue_ball.value].state.r);
}

/// From the cue ball to the 8-ball.
Vec2 aim_of(const GameState& state) {
    const auto eight = find_ball(state.scene, kEightBallId);
    if (!eight) return {1, 0};
    return xy(state.scene.balls[eight->value].state.r) - cue_ball_of(state);
}

Legal legal(const GameState& state) {
    Legal legal;
    legal.seat = state.turn;
    legal.aim = aim_of(state);
    if (state.over) return legal;
    legal.shoot = StrokeBounds{kShotSpeed, kShotSpeed, kShotSpeed, 0, 0};
    if (std::get<EndGamePart>(state.part).in_hand) {
        const double edge = inset(state.scene.table, state.scene.ball.radius).y;
        legal.place = Region{{kBaseLineX, -edge}, {kBaseLineX, edge}};
    }
    return legal;
}

/// When the ball left the table in this way, if it did.
std::optional<double> time_of(const ShotTrace& trace, EventKind kind,
                              std::optional<BallIndex> ball) {
    for (const ShotEvent& event : trace.events) {
        if (event.kind == kind && event.balls[0] == ball) return event.t;
    }
    return std::nullopt;
}

/// When the cue ball went down or over a rail, if it did.
std::optional<double> time_of_scratch(const ShotTrace& trace, BallIndex cue) {
    const auto down = time_of(trace, EventKind::kBallPocket, cue);
    return down ? down : time_of(trace, EventKind::kOffTable, cue);
}

/// A free place on the line across the table at x, the middle if it is free. One other ball cannot
/// block all three.
Vec2 free_place(const Scene& scene, std::size_t moved, double x) {
    const double diameter = 2 * scene.ball.radius;
    for (const double y : {0.0, 2 * diameter, -2 * diameter}) {
        const bool free =
            std::none_of(scene.balls.begin(), scene.balls.end(), [&](const SceneBall& ball) {
                return &ball != &scene.balls[moved] &&
                       norm(xy(ball.state.r) - Vec2{x, y}) < diameter;
            });
        if (free) return {x, y};
    }
    return {x, 0};
}

void respot(Scene& scene, std::size_t ball, double x) {
    set_xy(scene.balls[ball].state.r, free_place(scene, ball, x));
}

/// Leaves the scene as the shot did, at rest. A sunk 8-ball is off it, and one that jumped over a
/// rail is back on its spot; the cue ball, gone in either way, returns to the base line.
void clear_table(Scene& scene, const ShotTrace& trace, BallIndex cue) {
    lay_at_rest(scene, trace);
    for (std::size_t i = trace.balls.size(); i-- > 0;) {
        if (i == cue.value) continue;
        if (trace.balls[i].motion == Motion::kOffTable) respot(scene, i, kFootSpotX);
        if (trace.balls[i].motion == Motion::kPocketed)
            scene.balls.erase(scene.balls.begin() + static_cast<std::ptrdiff_t>(i));
    }
    const Motion left = trace.balls[cue.value].motion;
    if (left == Motion::kPocketed || left == Motion::kOffTable)
        respot(scene, cue.value, kBaseLineX);
    part_overlapping(scene);
}

Turn shoot(const GameState& state, const Stroke& stroke) {
    Turn turn;
    SimulatedShot& shot = turn.shot.emplace();
    shot.scene = state.scene;
    shot.scene.strike = Strike{state.cue_ball, stroke.direction, *stroke.speed};
    simulate(shot.scene, kPlayoutHz, shot.trace);
    const Ruling ruling = rule(state, shot.trace);
    turn.ruling = ruling;

    turn.state = state;
    turn.state.shots = state.shots + 1;
    turn.state.winner = ruling.winner;
    turn.state.over = ruling.winner.has_value();
    turn.state.part = EndGamePart{.in_hand = false};
    if (!turn.state.over) turn.state.turn = ruling.next;
    clear_table(turn.state.scene, shot.trace, state.cue_ball);
    return turn;
}

Turn place(const GameState& state, Vec2 position) {
    Turn turn;
    turn.state = state;
    set_xy(turn.state.scene.balls[state.cue_ball.value].state.r, position);
    return turn;
}

/// The balls stay where they are.
Turn time_out(const GameState& state) {
    Turn turn;
    turn.state = state;
    turn.state.turn = opponent(state.turn);
    turn.ruling = Ruling{Verdict::kTimedOut, state.turn, opponent(state.turn), {}, 0};
    return turn;
}

Turn play(const GameState& state, const Move& move) {
    if (const auto* shot = std::get_if<Shoot>(&move)) return shoot(state, shot->strike);
    if (const auto* placement = std::get_if<Place>(&move)) return place(state, placement->position);
    assert(std::holds_alternative<TimeOut>(move));
    return time_out(state);
}

}  // namespace

Ruling end_game::rule(const GameState& state, const ShotTrace& trace) {
    Ruling ruling;
    ruling.shooter = state.turn;
    ruling.next = opponent(state.turn);
    if (const auto scratch = time_of_scratch(trace, state.cue_ball)) {
        ruling.verdict = Verdict::kScratch;
        ruling.winner = opponent(state.turn);
        ruling.decided_at = *scratch;
        return ruling;
    }
    ruling.decided_at = trace.duration;
    if (time_of(trace, EventKind::kBallPocket, find_ball(state.scene, kEightBallId))) {
        ruling.verdict = Verdict::kWon;
        ruling.winner = state.turn;
    }
    return ruling;
}

constinit const Ruleset kEndGameRules{EndGamePart::kType, new_game, legal, play};

const Ruleset& EndGamePart::rules() {
    return kEndGameRules;
}

}  // namespace poolhall
