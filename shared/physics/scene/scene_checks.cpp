#include "shared/physics/scene/scene_checks.hpp"

#include "shared/physics/scene/field_checks.hpp"
#include "shared/table/pool_table.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace poolhall::scene_checks {

namespace {

MaybeError check_circles(const Table& table) {
    for (std::size_t i = 0; i < table.circles.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (table.circles[i].id == table.circles[j].id)
                return SceneError{"/table/pockets/" + std::to_string(i) + "/id",
                                  "is the same as /table/pockets/" + std::to_string(j) + "/id"};
        }
    }
    return std::nullopt;
}

MaybeError check_pockets(const Scene& scene) {
    const Table& table = scene.table;
    if (table.pockets == PocketModel::kCircles) return check_circles(table);
    if (table.pockets == PocketModel::kNone) return std::nullopt;
    if (!table.rails) return SceneError{"/table/pockets", "needs a table with rails"};
    if (table.pockets != PocketModel::kPool) return std::nullopt;
    if (const auto fault = fault_of_mouths(table))
        return SceneError{"/table" + std::string(fault->pointer), std::string(fault->reason)};
    if (!fits_pool_table(table, scene.ball.radius))
        return SceneError{"/ball/radius", "is too large for the mouths of a pool table"};
    return std::nullopt;
}

/// Whether every ball reaches above that height.
bool all_balls_reach_above(const Scene& scene, Real height) {
    return height < 2 * scene.ball.radius &&
           std::all_of(scene.balls.begin(), scene.balls.end(),
                       [&](const SceneBall& ball) { return height < 2 * radius_of(scene, ball); });
}

MaybeError check_contact_height(const Scene& scene) {
    const Table& table = scene.table;
    if (!table.nose_height || !table.rails) return std::nullopt;
    if (!all_balls_reach_above(scene, *table.nose_height))
        return SceneError{"/table/nose_height", "must be below the top of every ball"};
    const RailSpec& rail = scene.effects.rail;
    if (!has_nose(rail.model) || rail.nose_height == *table.nose_height) return std::nullopt;
    return SceneError{"/table/nose_height", "must be the same as /effects/rail/nose_height"};
}

}  // namespace

MaybeError check_table(const Scene& scene) {
    if (auto error = check_field(scene, "id")) return error;
    if (auto error = check_field(scene, "table")) return error;
    if (auto error = check_field(scene, "ball")) return error;
    if (auto error = check_field(scene, "gravity")) return error;
    const Real least = 4 * scene.ball.radius;
    if (scene.table.length < least || scene.table.width < least) {
        return SceneError{"/table",
                          "is too small for its balls: both sides need at least two diameters"};
    }
    if (auto error = check_contact_height(scene)) return error;
    return check_pockets(scene);
}

MaybeError check_effects(const Scene& scene) {
    if (auto error = check_field(scene, "effects")) return error;
    const RailSpec& rail = scene.effects.rail;
    if (!has_nose(rail.model) || !scene.table.rails) return std::nullopt;
    if (all_balls_reach_above(scene, rail.nose_height)) return std::nullopt;
    return SceneError{"/effects/rail/nose_height", "must be below the top of every ball"};
}

MaybeError check_solver_spec(const Scene& scene) {
    return check_field(scene, "solver");
}

MaybeError check_limits(const Scene& scene) {
    return check_field(scene, "limits");
}

MaybeError check_strike(const Scene& scene) {
    if (!scene.strike) return std::nullopt;
    const Strike& strike = *scene.strike;
    if (strike.ball.value >= scene.balls.size())
        return SceneError{"/strike/ball", "names no ball of the scene"};
    const auto [x, y] = strike.direction;
    if (!std::isfinite(x) || !std::isfinite(y))
        return SceneError{"/strike/direction", "must be finite"};
    if (x == 0 && y == 0) return SceneError{"/strike/direction", "must not be zero"};
    if (!(dot(strike.offset, strike.offset) < 1))
        return SceneError{"/strike/offset", "must be shorter than 1, or the tip misses the ball"};
    return check_field(scene, "strike");
}

}  // namespace poolhall::scene_checks
