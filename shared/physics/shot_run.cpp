#include "shared/physics/shot_run.hpp"

#include <algorithm>

namespace poolhall {

namespace {

bool moves(const MovingBall& ball) {
    return ball.v.x != 0 || ball.v.y != 0;
}

BallIndex index_of(std::size_t ball) {
    return BallIndex{static_cast<std::uint16_t>(ball)};
}

}  // namespace

ShotRun::ShotRun(const Scene& scene, double sample_hz, ShotTrace& trace)
    : scene_(scene), trace_(trace) {
    trace_.events.clear();
    trace_.samples.clear();
    trace_.balls.assign(scene.balls.size(), FinalBall{});
    trace_.sample_hz = sample_hz;
    if (sample_hz > 0) next_sample_ = 0;
    balls_.reserve(scene.balls.size());
    for (const SceneBall& ball : scene.balls)
        balls_.push_back({xy(ball.state.r), xy(ball.state.v)});
    strike();
}

void ShotRun::strike() {
    if (!scene_.strike) return;
    const std::size_t struck = scene_.strike->ball.value;
    const MovingBall before = balls_[struck];
    balls_[struck].v = scene_.strike->speed * normalized(scene_.strike->direction);
    add_event(0, EventKind::kStrike, struck, before);
}

bool ShotRun::any_moves() const {
    for (const MovingBall& ball : balls_) {
        if (moves(ball)) return true;
    }
    return false;
}

BallState ShotRun::state_of(std::size_t ball, const MovingBall& moving) const {
    BallState state = scene_.balls[ball].state;
    set_xy(state.r, moving.r);
    set_xy(state.v, moving.v);
    if (!moving.in_play) state.w = {};
    return state;
}

ShotEvent& ShotRun::add_event(double t, EventKind kind, std::size_t ball,
                              const MovingBall& before) {
    ShotEvent& event = trace_.events.emplace_back();
    event.t = t;
    event.kind = kind;
    event.balls[0] = index_of(ball);
    event.before[0] = state_of(ball, before);
    event.after[0] = state_of(ball, balls_[ball]);
    return event;
}

void ShotRun::record_pair(double t, std::size_t a, std::size_t b, const MovingBall& before_a,
                          const MovingBall& before_b) {
    balls_[a].partner = b;
    balls_[b].partner = a;
    ShotEvent& event = add_event(t, EventKind::kBallBall, a, before_a);
    event.ball_count = 2;
    event.balls[1] = index_of(b);
    event.before[1] = state_of(b, before_b);
    event.after[1] = state_of(b, balls_[b]);
}

void ShotRun::record_rail(double t, std::size_t ball, Rail rail, const MovingBall& before) {
    balls_[ball].partner = MovingBall::kNobody;
    add_event(t, EventKind::kBallRail, ball, before).rail = rail;
}

void ShotRun::capture(double t, std::size_t ball, Pocket pocket) {
    const MovingBall before = balls_[ball];
    balls_[ball].in_play = false;
    balls_[ball].v = {};
    trace_.balls[ball].motion = Motion::kPocketed;
    trace_.balls[ball].pocket = pocket;
    add_event(t, EventKind::kBallPocket, ball, before).pocket = pocket;
}

void ShotRun::record_rest(double t, std::size_t ball, const MovingBall& before) {
    balls_[ball].partner = MovingBall::kNobody;
    add_event(t, EventKind::kRollToRest, ball, before);
}

void ShotRun::sort_events_from(std::size_t first) {
    std::stable_sort(trace_.events.begin() + static_cast<std::ptrdiff_t>(first),
                     trace_.events.end(),
                     [](const ShotEvent& a, const ShotEvent& b) { return a.t < b.t; });
}

void ShotRun::sample_between(double from, double to) {
    for (; next_sample_ < to; set_next_sample()) {
        for (const MovingBall& ball : balls_)
            trace_.samples.push_back(ball.r + (next_sample_ - from) * ball.v);
    }
}

void ShotRun::sample_at(double t) {
    for (; next_sample_ <= t; set_next_sample()) {
        for (const MovingBall& ball : balls_)
            trace_.samples.push_back(ball.r);
    }
}

void ShotRun::finish(Outcome outcome, double t, std::uint64_t ticks) {
    trace_.outcome = outcome;
    trace_.ticks = ticks;
    trace_.duration = t;
    if (outcome == Outcome::kRest)
        trace_.duration = trace_.events.empty() ? 0 : trace_.events.back().t;
    for (std::size_t i = 0; i < balls_.size(); ++i) {
        FinalBall& final = trace_.balls[i];
        final.state = state_of(i, balls_[i]);
        if (final.motion != Motion::kPocketed && moves(balls_[i])) final.motion = Motion::kRolling;
    }
    // The last sample shows the end: the first that is due at or after it.
    if (trace_.sample_hz > 0 &&
        (samples_ == 0 || static_cast<double>(samples_ - 1) / trace_.sample_hz < trace_.duration)) {
        sample_at(next_sample_);
    }
    trace_.hash = hash_of(trace_);
}

}  // namespace poolhall
