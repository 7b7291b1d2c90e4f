#include "protocol/wire/scene_fields.hpp"

#include <utility>

namespace poolhall::protocol::wire {
namespace {

bool read_schema(const Cursor& cursor) {
    const Json* schema = cursor.find("schema");
    if (schema == nullptr) return cursor.refuse_missing("schema");
    return *schema == kSceneSchema ||
           cursor.refuse_at("/schema", "must be \"" + std::string(kSceneSchema) + "\"");
}

/// Reads the strike of a scene whose balls are known.
bool read_strike(const Cursor& cursor, Scene& scene) {
    StrikeForm form;
    if (!read_fields(cursor, form)) return false;
    const auto ball = find_ball(scene, form.ball);
    if (!ball) return cursor.refuse_at("/ball", "must be the id of a ball");
    scene.strike = Strike{*ball, form.direction, form.speed};
    return true;
}

}  // namespace

bool SceneCodec::read(const Cursor& cursor, Scene& scene) const {
    if (!cursor.json().is_object()) return cursor.refuse("must be an object");
    if (!read_schema(cursor) || !read_fields(cursor, scene, {"schema", "strike"})) return false;
    if (const Json* strike = cursor.find("strike")) {
        if (!read_strike(cursor.field("strike", *strike), scene)) return false;
    } else if (strike_required) {
        return cursor.refuse_missing("strike");
    }
    const auto fault = check(scene);
    return !fault || cursor.refuse_at(fault->pointer, fault->reason);
}

Json SceneCodec::write(const Scene& scene, Encoding encoding) const {
    Json object{{"schema", kSceneSchema}};
    write_fields(object, scene, encoding);
    if (scene.strike) {
        const Strike& strike = *scene.strike;
        const StrikeForm form{scene.balls[strike.ball.value].id, strike.direction, strike.speed};
        object["strike"] = Object<StrikeForm>{}.write(form, encoding);
    }
    return object;
}

}  // namespace poolhall::protocol::wire
