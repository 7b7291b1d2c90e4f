#include "shared/physics/scene/field_checks.hpp"
#include "shared/physics/scene/scene_checks.hpp"
#include "shared/table/playing_area.hpp"
#include "shared/table/pool_table.hpp"

namespace poolhall::scene_checks {

namespace {

/// On a pool table.
MaybeError check_size(const Scene& scene, const SceneBall& ball, const std::string& pointer) {
    if (!ball.radius || scene.table.pockets != PocketModel::kPool ||
        fits_pool_table(scene.table, *ball.radius))
        return std::nullopt;
    return SceneError{pointer + "/radius", "is too large for the mouths of a pool table"};
}

/// Heights are for scenes in which balls fly.
MaybeError check_height(const Scene& scene, const BallState& state, const std::string& pointer) {
    if (state.r.z < 0) return SceneError{pointer + "/r/2", "must not be below the cloth"};
    if (scene.effects.airborne) return std::nullopt;
    if (state.r.z > 0) return SceneError{pointer + "/r/2", "must be 0 without the effect airborne"};
    if (state.v.z != 0)
        return SceneError{pointer + "/v/2", "must be 0 without the effect airborne"};
    return std::nullopt;
}

MaybeError check_ball(const Scene& scene, const SceneBall& ball, const std::string& pointer) {
    if (auto error = below(pointer, check_fields(ball))) return error;
    if (auto error = check_size(scene, ball, pointer)) return error;
    if (auto error = check_height(scene, ball.state, pointer)) return error;
    if (!is_on_table(scene.table, xy(ball.state.r), radius_of(scene, ball), kTouchTolerance))
        return SceneError{pointer + "/r", "is off the table"};
    return std::nullopt;
}

/// Balls on the cloth touch at this distance in the plane too: their centres' heights are in it.
bool overlap(const Scene& scene, const SceneBall& a, const SceneBall& b) {
    const Real r_a = radius_of(scene, a);
    const Real r_b = radius_of(scene, b);
    Vec3 gap = a.state.r - b.state.r;
    gap.z = gap.z + (r_a - r_b);
    return norm(gap) < r_a + r_b - kTouchTolerance;
}

std::string pointer_to(std::size_t ball) {
    return "/balls/" + std::to_string(ball);
}

/// Ball i against those before it.
MaybeError check_against_others(const Scene& scene, std::size_t i) {
    for (std::size_t j = 0; j < i; ++j) {
        if (scene.balls[i].id == scene.balls[j].id)
            return SceneError{pointer_to(i) + "/id", "is the same as " + pointer_to(j) + "/id"};
        if (overlap(scene, scene.balls[i], scene.balls[j]))
            return SceneError{pointer_to(i) + "/r", "overlaps " + pointer_to(j)};
    }
    return std::nullopt;
}

}  // namespace

MaybeError check_balls(const Scene& scene) {
    if (scene.balls.size() > kMaxBalls) return SceneError{"/balls", "must be at most 1024"};
    for (std::size_t i = 0; i < scene.balls.size(); ++i) {
        if (auto error = check_ball(scene, scene.balls[i], pointer_to(i))) return error;
        if (auto error = check_against_others(scene, i)) return error;
    }
    return std::nullopt;
}

}  // namespace poolhall::scene_checks
