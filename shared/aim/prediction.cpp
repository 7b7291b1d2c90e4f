#include "shared/aim/prediction.hpp"

#include "shared/physics/effects/ball_ball.hpp"
#include "shared/physics/effects/rails.hpp"
#include "shared/physics/time_of_impact.hpp"

#include <algorithm>
#include <limits>

namespace poolhall {

namespace {

/// A cue ball slower than this share of its speed after impact is shown as stopped: a full hit.
constexpr double kStopped = 1e-9;

/// The way from r along the unit vector `direction` up to the nearest rail.
PathSegment path_to_rail(const Rails& rails, Vec2 r, Vec2 direction, double reach) {
    double way = reach;
    for (const auto& hit :
         {rails.next_short_rail(r, direction), rails.next_long_rail(r, direction)}) {
        if (hit) way = std::min(way, hit->t);
    }
    return {r, r + way * direction};
}

}  // namespace

AimPrediction predict(const Scene& scene, BallIndex cue, Vec2 direction, double reach) {
    const Rails rails(scene);
    const Vec2 start = xy(scene.balls[cue.value].state.r);
    const Vec2 forward = normalized(direction);
    AimPrediction prediction;
    prediction.cue_path = {start, start};
    if (forward == Vec2{}) return prediction;
    prediction.cue_path = path_to_rail(rails, start, forward, reach);

    // At unit speed, time is way.
    double first = norm(prediction.cue_path.to - start);
    for (std::size_t i = 0; i < scene.balls.size(); ++i) {
        if (i == cue.value) continue;
        const auto way = time_of_impact({start, forward}, {xy(scene.balls[i].state.r), {}},
                                        2 * scene.ball.radius);
        if (!way || *way >= first) continue;
        first = *way;
        prediction.object_ball = BallIndex{static_cast<std::uint16_t>(i)};
    }
    if (!prediction.object_ball) return prediction;

    const Vec2 ghost = start + first * forward;
    const Vec2 object = xy(scene.balls[prediction.object_ball->value].state.r);
    Vec2 cue_after = forward;
    Vec2 object_after{};
    exchange_normal_velocity(cue_after, object_after, normalized(object - ghost));
    prediction.ghost_ball = ghost;
    prediction.cue_path = {start, ghost};
    if (norm(cue_after) > kStopped)
        prediction.cue_after = path_to_rail(rails, ghost, normalized(cue_after), reach);
    if (norm(object_after) > kStopped)
        prediction.object_after = path_to_rail(rails, object, normalized(object_after), reach);
    return prediction;
}

}  // namespace poolhall
