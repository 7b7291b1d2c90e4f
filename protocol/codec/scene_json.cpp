#include "protocol/codec/scene_json.hpp"

#include "protocol/wire/scene_fields.hpp"

#include <nlohmann/json.hpp>
#include <utility>

namespace poolhall::protocol {

Result<Scene, SceneError> scene_from_json(const nlohmann::ordered_json& json) {
    wire::Reading reading;
    Scene scene;
    if (wire::SceneCodec{}.read(wire::Cursor(json, reading), scene)) return scene;
    return SceneError{std::move(reading.error->pointer), std::move(reading.error->reason)};
}

nlohmann::ordered_json to_json(const Scene& scene) {
    return wire::SceneCodec{}.write(scene, Encoding::kJson);
}

}  // namespace poolhall::protocol
