#include "client/play/shot_timeline.hpp"

#include <algorithm>

namespace poolhall::client {

ShotTimeline::ShotTimeline(std::span<const Vec2> positions, double begin)
    : begin_(begin), known_until_(begin) {
    tracks_.reserve(positions.size());
    for (const Vec2 r : positions)
        tracks_.push_back({{{begin, r}}, std::nullopt});
}

void ShotTimeline::extend(double t, std::span<const ShotEvent> events,
                          std::span<const Moved> moved) {
    if (complete_ || !(t > known_until_)) return;
    for (const ShotEvent& event : events)
        add_event(event, t);
    for (Track& track : tracks_)
        track.knots.push_back({t, track.knots.back().r});
    for (const Moved& ball : moved) {
        if (ball.ball.value < tracks_.size()) tracks_[ball.ball.value].knots.back().r = ball.r;
    }
    known_until_ = t;
}

void ShotTimeline::add_event(const ShotEvent& event, double latest) {
    if (!of_this_shot(event)) return;
    const double earliest = events_.empty() ? begin_ : events_.back().t;
    events_.push_back(event);
    events_.back().t = std::clamp(event.t, std::min(earliest, latest), latest);
    const double t = events_.back().t;
    for (std::size_t i = 0; i < event.ball_count; ++i) {
        Track& track = tracks_[event.balls[i].value];
        if (t >= track.knots.back().t) track.knots.push_back({t, xy(event.after[i].r)});
        if (event.kind == EventKind::kBallPocket) track.sunk_at = t;
    }
}

bool ShotTimeline::of_this_shot(const ShotEvent& event) const {
    if (event.ball_count < 1 || event.ball_count > event.balls.size()) return false;
    return std::all_of(event.balls.begin(), event.balls.begin() + event.ball_count,
                       [&](BallIndex ball) { return ball.value < tracks_.size(); });
}

void ShotTimeline::finish(double duration, std::span<const FinalBall> balls) {
    if (complete_ || balls.size() != tracks_.size()) return;
    const double end = std::max(duration, begin_);
    for (std::size_t i = 0; i < balls.size(); ++i) {
        // The last tick may lie a little after the end; its rounded position gives way to the exact
        // one.
        auto& knots = tracks_[i].knots;
        while (!knots.empty() && knots.back().t >= end)
            knots.pop_back();
        knots.push_back({end, xy(balls[i].state.r)});
        if (balls[i].motion == Motion::kPocketed && !tracks_[i].sunk_at) tracks_[i].sunk_at = end;
    }
    known_until_ = end;
    complete_ = true;
}

Vec2 ShotTimeline::position(BallIndex ball, double t) const {
    const auto& knots = tracks_[ball.value].knots;
    const auto next = std::upper_bound(knots.begin(), knots.end(), t,
                                       [](double time, const Knot& knot) { return time < knot.t; });
    if (next == knots.begin()) return knots.front().r;
    if (next == knots.end()) return knots.back().r;
    const Knot& last = *(next - 1);
    const double share = (t - last.t) / (next->t - last.t);
    return last.r + share * (next->r - last.r);
}

bool ShotTimeline::sunk(BallIndex ball, double t) const {
    const auto& sunk_at = tracks_[ball.value].sunk_at;
    return sunk_at && *sunk_at <= t;
}

std::size_t ShotTimeline::events_until(double t) const {
    const auto later =
        std::upper_bound(events_.begin(), events_.end(), t,
                         [](double time, const ShotEvent& event) { return time < event.t; });
    return static_cast<std::size_t>(later - events_.begin());
}

ShotTimeline timeline_of(const SimulatedShot& shot) {
    const ShotTrace& trace = shot.trace;
    ShotTimeline timeline(positions_of(shot.scene));
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
    return timeline;
}

std::vector<Vec2> positions_of(const Scene& scene) {
    std::vector<Vec2> positions;
    positions.reserve(scene.balls.size());
    for (const SceneBall& ball : scene.balls)
        positions.push_back(xy(ball.state.r));
    return positions;
}

}  // namespace poolhall::client
