#pragma once

#include "shared/physics/scene/scene.hpp"
#include "shared/physics/scene/trace.hpp"

#include <span>
#include <vector>

// Where the balls of a trace went, to be drawn.
namespace poolhall::analysis {

struct PathPoint {
    double t = 0;  ///< s since the strike
    Vec2 r;        ///< m
};

/// In order of time, from the scene's place to the last; straight between the points.
using Path = std::vector<PathPoint>;

/// A path for each ball, in the scene's order: the trace's samples, and the exact places of all
/// that happened between them, so that a bounce is a corner.
[[nodiscard]] std::vector<Path> paths_of(const Scene& scene, const ShotTrace& trace);

/// Where the ball is at `t`; before and after the path it stands at its ends. The path must have a
/// point.
[[nodiscard]] Vec2 place_at(const Path& path, double t);

/// The line that the path draws, with as few points as keep it within `tolerance` m.
[[nodiscard]] std::vector<Vec2> outline_of(const Path& path, double tolerance);

/// Where the balls' centres were when they met each other or a rail, m.
[[nodiscard]] std::vector<Vec2> impacts_of(const ShotTrace& trace);

}  // namespace poolhall::analysis
