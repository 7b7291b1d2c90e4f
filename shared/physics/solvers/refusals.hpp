#pragma once

#include "shared/physics/scene/scene.hpp"

#include <optional>

// Why a solver cannot do what a scene asks for, as far as several solvers share it.
namespace poolhall {

/// Of solvers that step with the forces of a tick's beginning or end.
[[nodiscard]] std::optional<SceneError> refusal_by_euler_steps(const Scene& scene);

/// Of solvers that move balls in closed form.
[[nodiscard]] std::optional<SceneError> refusal_by_closed_form(const Scene& scene);

}  // namespace poolhall
