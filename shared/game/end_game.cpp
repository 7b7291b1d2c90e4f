#include "shared/game/end_game.hpp"

#include "shared/game/resting.hpp"
#include "shared/physics/simulate.hpp"

#include <algorithm>
#include <cmath>

namespace poolhall {

namespace {

using namespace end_game;

/// How far off the base line a requested place may be, m: a client's arithmetic may round
/// differently.
constexpr double kBaseLineTolerance = 1e-6;

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

bool placeable(const GameState& state) {
    return !state.over && state.shots == 0;
}

std::optional<Vec2> nearest_placement(const GameState& state, Vec2 position) {
    if (!placeable(state)) return std::nullopt;
    const double edge = inset(state.scene.table, state.scene.ball.radius).y;
    return Vec2{kBaseLineX, std::clamp(position.y, -edge, edge)};
}

std::optional<Illegal> place_cue_ball(GameState& state, Vec2 position) {
    if (!placeable(state)) return Illegal::kNotPlaceable;
    const double edge = inset(state.scene.table, state.scene.ball.radius).y;
    const bool on_line =
        std::abs(position.x - kBaseLineX) <= kBaseLineTolerance && std::abs(position.y) <= edge;
    if (!on_line) return Illegal::kOutOfPlace;
    set_xy(state.scene.balls[state.cue_ball.value].state.r, {kBaseLineX, position.y});
    return std::nullopt;
}

Vec2 default_aim(const GameState& state) {
    const auto eight = find_ball(state.scene, kEightBallId);
    if (!eight) return {1, 0};
    return xy(state.scene.balls[eight->value].state.r) -
           xy(state.scene.balls[state.cue_ball.value].state.r);
}

std::optional<Illegal> check_shot(const GameState& state, const ShotCommand& command) {
    if (state.over) return Illegal::kGameOver;
    const auto [x, y] = command.direction;
    if (!std::isfinite(x) || !std::isfinite(y) || (x == 0 && y == 0)) return Illegal::kBadDirection;
    return std::nullopt;
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

ShotOutcome play(const GameState& state, const ShotCommand& command) {
    ShotOutcome outcome;
    outcome.scene = state.scene;
    outcome.scene.strike = Strike{state.cue_ball, command.direction, kShotSpeed};
    simulate(outcome.scene, kPlayoutHz, outcome.trace);
    outcome.ruling = rule(state, outcome.trace);

    outcome.state = state;
    outcome.state.shots = state.shots + 1;
    outcome.state.winner = outcome.ruling.winner;
    outcome.state.over = outcome.ruling.winner.has_value();
    if (!outcome.state.over) outcome.state.turn = outcome.ruling.next;
    clear_table(outcome.state.scene, outcome.trace, state.cue_ball);
    return outcome;
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

constinit const Ruleset kEndGameRules{
    "end_game", new_game, place_cue_ball, nearest_placement, default_aim, check_shot, play};

}  // namespace poolhall
