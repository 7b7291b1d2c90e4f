#pragma once

#include "shared/physics/scene/scene.hpp"
#include "shared/result.hpp"

#include <nlohmann/json_fwd.hpp>

// Files of schema poolhall.scene/1. The trees keep the order of their fields, so that what is
// written reads as the schema lists it; a plain nlohmann::json converts to and from them.
namespace poolhall::protocol {

/// Reads a scene and check()s it. Numbers may be JSON numbers or C hex-float strings. Unknown
/// fields, effects and models are refused; the error's pointer says where.
[[nodiscard]] Result<Scene, SceneError> scene_from_json(const nlohmann::ordered_json& json);
/// Writes every field, so that reading it back gives an equal scene.
[[nodiscard]] nlohmann::ordered_json to_json(const Scene& scene);

}  // namespace poolhall::protocol
