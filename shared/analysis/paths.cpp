#include "shared/analysis/paths.hpp"

#include "shared/analysis/agreement.hpp"

#include <algorithm>

namespace poolhall::analysis {

namespace {

/// How far `r` is from the stretch between `from` and `to`, m.
double distance_from(Vec2 from, Vec2 to, Vec2 r) {
    const Vec2 way = to - from;
    const double square = dot(way, way);
    const double share = square > 0 ? std::clamp(dot(r - from, way) / square, 0.0, 1.0) : 0;
    return norm(r - (from + share * way));
}

/// Adds what a line from `first` to `last` leaves out (Douglas and Peucker 1973), and `last`.
void add_outline(const Path& path, std::size_t first, std::size_t last, double tolerance,
                 std::vector<Vec2>& outline) {
    std::size_t farthest = first;
    double most = tolerance;
    for (std::size_t i = first + 1; i < last; ++i) {
        const double distance = distance_from(path[first].r, path[last].r, path[i].r);
        if (distance <= most) continue;
        most = distance;
        farthest = i;
    }
    if (farthest == first) {
        outline.push_back(path[last].r);
        return;
    }
    add_outline(path, first, farthest, tolerance, outline);
    add_outline(path, farthest, last, tolerance, outline);
}

void add_samples(std::vector<Path>& paths, const ShotTrace& trace, double until,
                 std::size_t& sample) {
    for (; sample < trace.sample_count(); ++sample) {
        const double t = static_cast<double>(sample) / trace.sample_hz;
        if (t >= until) return;
        for (std::size_t i = 0; i < paths.size(); ++i)
            paths[i].push_back({t, xy(trace.sample(sample, i))});
    }
}

}  // namespace

std::vector<Path> paths_of(const Scene& scene, const ShotTrace& trace) {
    std::vector<Path> paths;
    for (const SceneBall& ball : scene.balls)
        paths.push_back({{0, xy(ball.state.r)}});
    std::size_t sample = 1;
    for (const ShotEvent& event : trace.events) {
        add_samples(paths, trace, event.t, sample);
        for (std::size_t i = 0; i < event.ball_count; ++i)
            paths[event.balls[i].value].push_back({event.t, xy(event.after[i].r)});
    }
    add_samples(paths, trace, trace.duration, sample);
    for (std::size_t i = 0; i < paths.size(); ++i)
        paths[i].push_back({trace.duration, xy(trace.balls[i].state.r)});
    return paths;
}

Vec2 place_at(const Path& path, double t) {
    const auto next =
        std::upper_bound(path.begin(), path.end(), t,
                         [](double time, const PathPoint& point) { return time < point.t; });
    if (next == path.begin()) return path.front().r;
    if (next == path.end()) return path.back().r;
    const PathPoint& last = *(next - 1);
    const double share = (t - last.t) / (next->t - last.t);
    return last.r + share * (next->r - last.r);
}

std::vector<Vec2> outline_of(const Path& path, double tolerance) {
    std::vector<Vec2> outline;
    if (path.empty()) return outline;
    outline.push_back(path.front().r);
    if (path.size() > 1) add_outline(path, 0, path.size() - 1, tolerance, outline);
    return outline;
}

std::vector<Vec2> impacts_of(const ShotTrace& trace) {
    std::vector<Vec2> places;
    for (const ShotEvent& event : trace.events) {
        if (!is_impact(event)) continue;
        for (std::size_t i = 0; i < event.ball_count; ++i)
            places.push_back(xy(event.after[i].r));
    }
    return places;
}

}  // namespace poolhall::analysis
