#pragma once

#include "shared/physics/scene/scene.hpp"

#include <optional>

// The parts of check(). Each names the first thing that is wrong, by a pointer from the scene on.
namespace poolhall::scene_checks {

using MaybeError = std::optional<SceneError>;

/// Table, common ball and gravity.
[[nodiscard]] MaybeError check_table(const Scene& scene);
[[nodiscard]] MaybeError check_effects(const Scene& scene);
[[nodiscard]] MaybeError check_solver_spec(const Scene& scene);
[[nodiscard]] MaybeError check_limits(const Scene& scene);
/// The table must have passed.
[[nodiscard]] MaybeError check_balls(const Scene& scene);
/// The balls must have passed.
[[nodiscard]] MaybeError check_strike(const Scene& scene);

}  // namespace poolhall::scene_checks
