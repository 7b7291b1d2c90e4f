#include "shared/physics/scene/scene.hpp"

#include "shared/physics/effects/kernels.hpp"
#include "shared/physics/scene/scene_checks.hpp"
#include "shared/table/pool_table.hpp"

#include <cmath>

namespace poolhall {

namespace {

using namespace scene_checks;

constexpr Real kMaxTime = 1e6;   ///< s
constexpr Real kMaxTicks = 1e9;  ///< what a minute or so can simulate
constexpr Real kMaxSlope = 10;   ///< of a cue
constexpr std::uint32_t kMaxEvents = 10'000'000;

MaybeError check_circles(const Table& table) {
    if (table.circles.size() > kMaxPocketCircles)
        return SceneError{"/table/pockets", "must be at most 64 circles"};
    for (std::size_t i = 0; i < table.circles.size(); ++i) {
        const std::string pointer = "/table/pockets/" + std::to_string(i);
        const PocketCircle& circle = table.circles[i];
        if (circle.id.empty() || circle.id.size() > kMaxIdBytes)
            return SceneError{pointer + "/id", "must have 1 to 64 bytes"};
        for (std::size_t j = 0; j < i; ++j) {
            if (circle.id == table.circles[j].id)
                return SceneError{pointer + "/id",
                                  "is the same as /table/pockets/" + std::to_string(j) + "/id"};
        }
        if (auto error = in_range(circle.centre.x, -kMaxLength, kMaxLength, pointer + "/x"))
            return error;
        if (auto error = in_range(circle.centre.y, -kMaxLength, kMaxLength, pointer + "/y"))
            return error;
        if (auto error = positive(circle.radius, kMaxLength, pointer + "/radius")) return error;
    }
    return std::nullopt;
}

MaybeError check_pockets(const Scene& scene) {
    const Table& table = scene.table;
    if (table.pockets == PocketModel::kCircles) return check_circles(table);
    if (table.pockets == PocketModel::kNone) return std::nullopt;
    if (!table.rails) return SceneError{"/table/pockets", "needs a table with rails"};
    if (table.pockets != PocketModel::kPool) return std::nullopt;
    if (!is_large_enough_for_pool(table))
        return SceneError{"/table", "is too small for six mouths: more than 0.319 m by 0.179 m"};
    if (!fits_pool_table(scene.ball.radius))
        return SceneError{"/ball/radius", "is too large for the mouths of a pool table"};
    return std::nullopt;
}

MaybeError check_table(const Scene& scene) {
    if (auto error = positive(scene.table.length, kMaxLength, "/table/length")) return error;
    if (auto error = positive(scene.table.width, kMaxLength, "/table/width")) return error;
    if (auto error = positive(scene.ball.radius, kMaxLength, "/ball/radius")) return error;
    if (auto error = positive(scene.ball.mass, kMaxLength, "/ball/mass")) return error;
    if (auto error = in_range(scene.gravity, 0, kMaxLength, "/gravity")) return error;
    const Real least = 4 * scene.ball.radius;
    if (scene.table.length < least || scene.table.width < least) {
        return SceneError{"/table",
                          "is too small for its balls: both sides need at least two diameters"};
    }
    return check_pockets(scene);
}

/// Whether the solver steps with the forces of a tick's beginning or end.
bool is_euler(SolverKind kind) {
    return kind == SolverKind::kEuler || kind == SolverKind::kSemiImplicit ||
           kind == SolverKind::kOverlap;
}

/// Whether the solver can do what the scene asks of it.
MaybeError check_solver(const Scene& scene) {
    const auto [kind, hz] = scene.solver;
    const Effects& effects = scene.effects;
    if (auto error = in_range(hz, kMinSolverHz, kMaxSolverHz, "/solver/hz")) return error;
    const bool drag = effects.linear_drag && effects.linear_drag->k > 0;
    if (is_euler(kind) && drag && effects.linear_drag->k >= hz)
        return SceneError{"/effects/linear_drag/k",
                          "must be below the solver's hz: an Euler step would turn the ball round"};
    const bool cloth = (effects.sliding && effects.sliding->mu > 0) ||
                       (effects.rolling && effects.rolling->mu > 0);
    if (!is_euler(kind) && drag && cloth)
        return SceneError{"/solver/kind",
                          "has no closed form of linear_drag together with sliding or rolling"};
    if (!is_euler(kind) && SetOf<AllEffects>::calls_for_force(scene))
        return SceneError{"/solver/kind", "has no closed form of a force that the scene calls for"};
    if (kind == SolverKind::kOverlap && scene.table.pockets == PocketModel::kPool)
        return SceneError{"/solver/kind", "overlap knows no mouths: not on a pool table"};
    if (kind == SolverKind::kOverlap && effects.airborne)
        return SceneError{"/solver/kind", "overlap knows no heights: not with airborne"};
    return std::nullopt;
}

MaybeError check_limits(const Scene& scene) {
    if (auto error = positive(scene.limits.time, kMaxTime, "/limits/time")) return error;
    const bool ticks = scene.solver.kind != SolverKind::kEvent;
    if (ticks && scene.limits.time * scene.solver.hz > kMaxTicks)
        return SceneError{"/limits/time", "must be at most a billion ticks of the solver"};
    if (scene.limits.events == 0 || scene.limits.events > kMaxEvents)
        return SceneError{"/limits/events", "must be 1 to 10000000"};
    return std::nullopt;
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
    if (auto error = in_range(strike.speed, 0, kMaxSpeed, "/strike/speed")) return error;
    if (!(dot(strike.offset, strike.offset) < 1))
        return SceneError{"/strike/offset", "must be shorter than 1, or the tip misses the ball"};
    if (auto error = in_range(strike.elevation, 0, kMaxSlope, "/strike/elevation")) return error;
    return in_range(strike.end_mass_ratio, 0, 1, "/strike/end_mass_ratio");
}

}  // namespace

namespace scene_checks {

MaybeError in_range(Real x, Real low, Real high, const std::string& pointer) {
    if (x >= low && x <= high) return std::nullopt;
    return SceneError{pointer, "must be a finite number within its bounds"};
}

MaybeError positive(Real x, Real high, const std::string& pointer) {
    if (x > 0 && x <= high) return std::nullopt;
    return SceneError{pointer, "must be positive and within its bounds"};
}

}  // namespace scene_checks

std::optional<SceneError> check(const Scene& scene) {
    for (const auto part :
         {check_table, check_effects, check_solver, check_limits, check_balls, check_strike}) {
        if (auto error = part(scene)) return error;
    }
    return std::nullopt;
}

std::optional<BallIndex> find_ball(const Scene& scene, std::string_view id) {
    for (std::size_t i = 0; i < scene.balls.size(); ++i) {
        if (scene.balls[i].id == id) return BallIndex{static_cast<std::uint16_t>(i)};
    }
    return std::nullopt;
}

}  // namespace poolhall
