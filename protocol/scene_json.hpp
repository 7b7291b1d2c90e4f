#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "shared/physics/scene.hpp"
#include "shared/physics/trace.hpp"
#include "shared/result.hpp"

// The files of schema poolhall.scene/1 and poolhall.result/1.
namespace poolhall::protocol {

/// Reads a scene and check()s it. Numbers may be JSON numbers or C hex-float strings. Unknown fields, effects and models
/// are refused; the error's pointer says where.
[[nodiscard]] Result<Scene, SceneError> scene_from_json(const nlohmann::json& json);
/// Writes every field, so that reading it back gives an equal scene.
[[nodiscard]] nlohmann::json to_json(const Scene& scene);

/// One ShotEvent with the scene's ball ids: {"t", "kind", "balls", "rail" | "pocket", "at", "before", "after"}.
[[nodiscard]] nlohmann::json to_json(const ShotEvent& event, const Scene& scene);
/// The result of simulating the scene, schema poolhall.result/1 (without "cost").
[[nodiscard]] nlohmann::json to_json(const ShotTrace& trace, const Scene& scene);

}  // namespace poolhall::protocol
