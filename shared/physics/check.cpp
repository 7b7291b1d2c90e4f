#include "shared/physics/check.hpp"

#include "shared/physics/scene/scene_checks.hpp"
#include "shared/physics/solvers/solvers.hpp"

namespace poolhall {

namespace {

using namespace scene_checks;

constexpr Real kMaxTicks = 1e9;  ///< what a minute or so can simulate

/// Whether the solver can do what the scene asks of it.
MaybeError check_solver(const Scene& scene) {
    if (auto error = check_solver_spec(scene)) return error;
    return solver_of(scene.solver.kind).refusal(scene);
}

MaybeError check_ticks(const Scene& scene) {
    const bool many = scene.limits.time * scene.solver.hz > kMaxTicks;
    if (!many || !solver_of(scene.solver.kind).has_ticks) return std::nullopt;
    return SceneError{"/limits/time", "must be at most a billion ticks of the solver"};
}

}  // namespace

std::optional<SceneError> check(const Scene& scene) {
    for (const auto part : {check_table, check_effects, check_solver, check_limits, check_ticks,
                            check_balls, check_strike}) {
        if (auto error = part(scene)) return error;
    }
    return std::nullopt;
}

}  // namespace poolhall
