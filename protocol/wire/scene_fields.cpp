#include "protocol/wire/scene_fields.hpp"

#include "shared/physics/check.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace poolhall::protocol::wire {
namespace {

bool read_schema(const Cursor& cursor) {
    const Json* schema = cursor.find("schema");
    if (schema == nullptr) return cursor.refuse_missing("schema");
    return *schema == kSceneSchema ||
           cursor.refuse_at("/schema", "must be \"" + std::string(kSceneSchema) + "\"");
}

/// How far a direction falls per horizontal way. Scales first, as normalized() does.
double slope(const Vec3& direction) {
    const double largest = std::max(std::abs(direction.x), std::abs(direction.y));
    return -direction.z / largest / norm(Vec2{direction.x / largest, direction.y / largest});
}

/// Reads the strike of a scene whose balls are known.
bool read_strike(const Cursor& cursor, Scene& scene) {
    StrikeForm form;
    if (!read_fields(cursor, form)) return false;
    const auto ball = find_ball(scene, form.ball);
    if (!ball) return cursor.refuse_at("/ball", "must be the id of a ball");
    if (form.direction.z != 0 && form.strike.elevation != 0)
        return cursor.refuse_at("/elevation", "must not be given besides a direction that falls");
    scene.strike = form.strike;
    scene.strike->ball = *ball;
    scene.strike->direction = xy(form.direction);
    if (form.direction.z == 0) return true;
    if (xy(form.direction) == Vec2{})
        return cursor.refuse_at("/direction", "must not point straight down");
    scene.strike->elevation = slope(form.direction);
    return true;
}

StrikeForm form_of(const Scene& scene, const Strike& strike) {
    return {scene.balls[strike.ball.value].id, {strike.direction.x, strike.direction.y, 0}, strike};
}

/// Gives the ball "cue" the size and mass that a set has for it, where it says none of its own.
void use_cue_ball_of(const Cursor& cursor, Scene& scene) {
    const Json* spec = cursor.find("ball");
    const Json* set = spec != nullptr ? cursor.field("ball", *spec).find("preset") : nullptr;
    const auto cue = find_ball(scene, "cue");
    if (set == nullptr || !cue) return;
    const auto own = cue_ball_of(*find<BallSet>(set->get_ref<const std::string&>()));
    if (!own) return;
    SceneBall& ball = scene.balls[cue->value];
    if (!ball.radius) ball.radius = own->radius;
    if (!ball.mass) ball.mass = own->mass;
}

constexpr List<Object<PocketCircle>> kCircleList{{}, kMaxPocketCircles};

}  // namespace

bool StrikeDirection::read(const Cursor& cursor, Vec3& value) const {
    if (!Vector3{2}.read(cursor, value)) return false;
    return value.z <= 0 || cursor.refuse("must not point upwards");
}

bool PocketsCodec::read(const Cursor& cursor, Table& table) const {
    if (cursor.json().is_array()) {
        table.pockets = PocketModel::kCircles;
        return kCircleList.read(cursor, table.circles);
    }
    if (cursor.json().is_string()) return Named<PocketModel>{}.read(cursor, table.pockets);
    return cursor.refuse("must be a string or an array of circles");
}

Json PocketsCodec::write(const Table& table, Encoding encoding) const {
    if (table.pockets == PocketModel::kCircles) return kCircleList.write(table.circles, encoding);
    return Named<PocketModel>{}.write(table.pockets, encoding);
}

bool SceneCodec::read(const Cursor& cursor, Scene& scene) const {
    if (!cursor.json().is_object()) return cursor.refuse("must be an object");
    if (!read_schema(cursor) || !read_fields(cursor, scene, {"schema", "strike"})) return false;
    use_cue_ball_of(cursor, scene);
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
        object["strike"] = Object<StrikeForm>{}.write(form_of(scene, *scene.strike), encoding);
    }
    return object;
}

}  // namespace poolhall::protocol::wire
