#pragma once

#include "shared/physics/scene/scene.hpp"

#include <optional>

namespace poolhall {

/// A straight stretch of a ball's centre, m.
struct PathSegment {
    Vec2 from;
    Vec2 to;
};

/// Problems 1.1 and 1.2 of the original text: what the cue ball would meet first.
struct AimPrediction {
    PathSegment cue_path;  ///< from the cue ball to the ghost ball, or to the first rail
    std::optional<Vec2>
        ghost_ball;  ///< centre of the cue ball at impact; none if a rail comes first
    std::optional<BallIndex> object_ball;  ///< the ball that is hit, with ghost_ball
    std::optional<PathSegment> cue_after;  ///< cue ball after impact up to a rail; none if it stops
    std::optional<PathSegment> object_after;  ///< object ball after impact up to a rail
};

/// Predicts the first impact of `cue` when it moves along `direction` (any length but zero; zero
/// gives an empty path). All balls are taken to be at rest. Without rails a path ends `reach`
/// metres away.
[[nodiscard]] AimPrediction predict(const Scene& scene, BallIndex cue, Vec2 direction,
                                    double reach = 10);

}  // namespace poolhall
