#include "shared/aim/prediction.hpp"

#include "shared/physics/contact/ball_ball.hpp"
#include "shared/physics/contact/time_of_impact.hpp"
#include "shared/physics/effects/rails.hpp"

#include <algorithm>
#include <limits>

namespace poolhall {

namespace {

/// A cue ball slower than this share of its speed after impact is shown as stopped: a full hit.
constexpr double kStopped = 1e-9;

/// The ways of balls of one size up to the nearest rail.
struct PathsToRails {
    Rails rails;
    double reach;  ///< m; where they end without rails

    /// From the ball's place along the unit vector `direction`.
    [[nodiscard]] PathSegment of(const MovingBall& ball, Vec2 direction) const {
        double way = reach;
        for (const auto& hit :
             {rails.next_short_rail(ball, direction), rails.next_long_rail(ball, direction)}) {
            if (hit) way = std::min(way, hit->t);
        }
        return {ball.r, ball.r + way * direction};
    }
};

MovingBall resting_ball(const Scene& scene, BallIndex index) {
    const SceneBall& ball = scene.balls[index.value];
    MovingBall resting;
    resting.r = xy(ball.state.r);
    resting.radius = radius_of(scene, ball);
    resting.reach = rail_reach(scene.table, resting.radius);
    return resting;
}

}  // namespace

AimPrediction predict(const Scene& scene, BallIndex cue, Vec2 direction, double reach) {
    const PathsToRails paths{Rails(scene), reach};
    MovingBall cue_ball = resting_ball(scene, cue);
    const Vec2 start = cue_ball.r;
    const Vec2 forward = normalized(direction);
    AimPrediction prediction;
    prediction.cue_path = {start, start};
    if (forward == Vec2{}) return prediction;
    prediction.cue_path = paths.of(cue_ball, forward);

    // At unit speed, time is way.
    double first = norm(prediction.cue_path.to - start);
    for (std::size_t i = 0; i < scene.balls.size(); ++i) {
        if (i == cue.value) continue;
        const BallIndex index{static_cast<std::uint16_t>(i)};
        const MovingBall ball = resting_ball(scene, index);
        const auto way =
            time_of_impact({start, forward}, {ball.r, {}}, contact_distance(cue_ball, ball));
        if (!way || *way >= first) continue;
        first = *way;
        prediction.object_ball = index;
    }
    if (!prediction.object_ball) return prediction;

    const Vec2 ghost = start + first * forward;
    const MovingBall object = resting_ball(scene, *prediction.object_ball);
    cue_ball.r = ghost;
    Vec2 cue_after = forward;
    Vec2 object_after{};
    exchange_normal_velocity(cue_after, object_after, normalized(object.r - ghost));
    prediction.ghost_ball = ghost;
    prediction.cue_path = {start, ghost};
    if (norm(cue_after) > kStopped)
        prediction.cue_after = paths.of(cue_ball, normalized(cue_after));
    if (norm(object_after) > kStopped)
        prediction.object_after = paths.of(object, normalized(object_after));
    return prediction;
}

}  // namespace poolhall
