#pragma once

#include "shared/physics/scene/scene.hpp"

#include <optional>

namespace poolhall {

/// The first thing that is wrong with the scene: not finite, out of range, unknown ball, overlap,
/// more than its solver can do.
[[nodiscard]] std::optional<SceneError> check(const Scene& scene);

}  // namespace poolhall
