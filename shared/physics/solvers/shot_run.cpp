#include "shared/physics/solvers/shot_run.hpp"

#include "shared/physics/motion/cue.hpp"

#include <algorithm>

namespace poolhall {

namespace {

Vec3 place(const MovingBall& ball) {
    return {ball.r.x, ball.r.y, ball.height};
}

}  // namespace

void place_balls(const Scene& scene, std::vector<MovingBall>& balls) {
    balls.clear();
    for (const SceneBall& ball : scene.balls) {
        MovingBall& moving = balls.emplace_back();
        moving.r = xy(ball.state.r);
        moving.v = xy(ball.state.v);
        moving.w = ball.state.w;
        moving.w.z += 0;  // as friction leaves it: without a sign where it is zero
        moving.height = ball.state.r.z;
        moving.climb = ball.state.v.z;
        moving.radius = radius_of(scene, ball);
        moving.reach = rail_reach(scene.table, moving.radius);
        moving.mass = mass_of(scene, ball);
    }
}

ShotRun::ShotRun(const Scene& scene, Real sample_hz, Workspace& workspace, ShotTrace& trace)
    : scene_(scene), trace_(trace), workspace_(workspace) {
    place_balls(scene, workspace_.balls);
    begin(sample_hz);
    if (scene.strike) deliver(*scene.strike);
}

ShotRun::ShotRun(const ShotFrom& shot, Real sample_hz, Workspace& workspace, ShotTrace& trace)
    : scene_(shot.scene), trace_(trace), workspace_(workspace) {
    workspace_.balls.assign(shot.balls.begin(), shot.balls.end());
    begin(sample_hz);
    deliver(shot.strike);
}

void ShotRun::begin(Real sample_hz) {
    trace_.events.clear();
    trace_.samples.clear();
    trace_.balls.assign(scene_.balls.size(), FinalBall{});
    trace_.sample_hz = sample_hz;
    if (sample_hz > 0) next_sample_ = 0;
    workspace_.in_scene.clear();
    for (std::size_t i = 0; i < balls().size(); ++i)
        workspace_.in_scene.push_back({static_cast<std::uint16_t>(i)});
    workspace_.contact_solver.prepare({.ball_ball = scene_.effects.ball_ball,
                                       .rail = scene_.effects.rail,
                                       .mu_table = slip_friction(scene_),
                                       .unit_mass = scene_.ball.mass,
                                       .pressed = presses_balls(scene_),
                                       .in_space = scene_.effects.airborne.has_value(),
                                       .balls = scene_.balls.size()});
}

void ShotRun::deliver(const Strike& strike) {
    const std::size_t struck = strike.ball.value;
    MovingBall& ball = balls()[struck];
    const MovingBall before = ball;
    const CueBallMotion motion =
        strike_motion(strike_of_ball(strike, {ball.radius, ball.mass}), ball.radius);
    ball.v = xy(motion.v);
    ball.climb = scene_.effects.airborne ? motion.v.z : 0;
    ball.w = motion.w;
    ball.w.z += 0;
    add_event(0, EventKind::kStrike, struck, before);
}

bool ShotRun::any_moves() const {
    return std::any_of(workspace_.balls.begin(), workspace_.balls.end(), [](const MovingBall& b) {
        return in_play(b) && b.motion != Motion::kStationary;
    });
}

ShotEvent& ShotRun::add_event(Real t, EventKind kind, std::size_t ball, const MovingBall& before) {
    return trace_.events.emplace_back(t, kind, workspace_.in_scene[ball], before, balls()[ball]);
}

void ShotRun::record(Real t, EventKind kind, std::size_t ball, const MovingBall& before) {
    balls()[ball].partner = MovingBall::kNobody;
    add_event(t, kind, ball, before);
}

void ShotRun::record_pair(Real t, std::size_t a, std::size_t b, const MovingBall& before_a,
                          const MovingBall& before_b) {
    ShotEvent& event = add_event(t, EventKind::kBallBall, a, before_a);
    event.ball_count = 2;
    event.balls[1] = workspace_.in_scene[b];
    event.before[1] = state_of(before_b);
    event.after[1] = state_of(balls()[b]);
}

void ShotRun::record_rail(Real t, std::size_t ball, Rail rail, const MovingBall& before) {
    add_event(t, EventKind::kBallRail, ball, before).rail = rail;
}

void ShotRun::capture(Real t, std::size_t ball, Pocket pocket) {
    trace_.balls[workspace_.in_scene[ball].value].pocket = pocket;
    take_away(t, ball, Motion::kPocketed, EventKind::kBallPocket).pocket = pocket;
}

void ShotRun::lose(Real t, std::size_t ball) {
    take_away(t, ball, Motion::kOffTable, EventKind::kOffTable);
}

ShotEvent& ShotRun::take_away(Real t, std::size_t ball, Motion to, EventKind kind) {
    MovingBall& moving = balls()[ball];
    const MovingBall before = moving;
    moving.motion = to;
    moving.v = {};
    moving.w = {};
    moving.climb = 0;
    return add_event(t, kind, ball, before);
}

void ShotRun::sort_events_from(std::size_t first) {
    // By insertion: they are few, and std::stable_sort would use the heap.
    const auto begin = trace_.events.begin() + static_cast<std::ptrdiff_t>(first);
    const auto earlier = [](const ShotEvent& a, const ShotEvent& b) { return a.t < b.t; };
    for (auto event = begin; event != trace_.events.end(); ++event)
        std::rotate(std::upper_bound(begin, event, *event, earlier), event, event + 1);
}

void ShotRun::sample_at(Real t) {
    while (next_sample_ <= t)
        sample([&](std::size_t i) { return place(balls()[i]); });
}

/// The last sample shows the end: the first that is due at or after it.
void ShotRun::end_samples() {
    const auto due_before_end = [this](std::uint64_t sample) {
        return static_cast<Real>(sample) / trace_.sample_hz < trace_.duration;
    };
    if (samples_ == 0 || due_before_end(samples_ - 1)) sample_at(next_sample_);
    // A tick may go on after the last event in it.
    while (samples_ > 1 && !due_before_end(samples_ - 2))
        --samples_;
    trace_.samples.resize(samples_ * scene_.balls.size());
}

void ShotRun::finish(Outcome outcome, Real t, std::uint64_t ticks) {
    trace_.outcome = outcome;
    trace_.ticks = ticks;
    trace_.duration = t;
    if (outcome == Outcome::kRest)
        trace_.duration = trace_.events.empty() ? 0 : trace_.events.back().t;
    if (balls().size() < scene_.balls.size()) {
        for (std::size_t i = 0; i < scene_.balls.size(); ++i)
            trace_.balls[i].state = scene_.balls[i].state;
    }
    for (std::size_t i = 0; i < balls().size(); ++i) {
        FinalBall& ball = trace_.balls[workspace_.in_scene[i].value];
        ball.motion = balls()[i].motion;
        ball.state = state_of(balls()[i]);
    }
    if (trace_.sample_hz > 0) end_samples();
    trace_.hash = hash_of(trace_);
}

}  // namespace poolhall
