#include "protocol/scene_json.hpp"

#include "protocol/wire/scene_fields.hpp"
#include "protocol/wire/shot_fields.hpp"

#include <nlohmann/json.hpp>
#include <utility>

namespace poolhall::protocol {
namespace {

using wire::Json;

constexpr Encoding kExact = Encoding::kJson;  ///< nothing that is written here is shortened

Json state_json(const BallState& state) {
    return wire::Object<BallState>{}.write(state, kExact);
}

/// {"cue": {"r", "v", "w"}, ...}.
Json states_json(const ShotEvent& event, const std::array<BallState, 2>& states,
                 const Scene& scene) {
    Json object = Json::object();
    for (std::size_t i = 0; i < event.ball_count; ++i) {
        object[scene.balls[event.balls[i].value].id] = state_json(states[i]);
    }
    return object;
}

/// Where an event happened: the ball's centre, or the point between two.
Json place_json(const ShotEvent& event) {
    Vec2 at = xy(event.before[0].r);
    if (event.ball_count == 2) at = 0.5 * (at + xy(event.before[1].r));
    return Json::array({at.x, at.y});
}

Json final_ball_json(const FinalBall& ball, const std::string& id) {
    Json object{{"id", id}};
    object.update(wire::FinalBallCodec{}.write(ball, kExact));
    return object;
}

Json samples_json(const ShotTrace& trace) {
    Json samples = Json::array();
    for (std::size_t k = 0; k < trace.sample_count(); ++k) {
        Json positions = Json::array();
        for (std::size_t i = 0; i < trace.balls.size(); ++i) {
            const Vec2 r = trace.sample(k, i);
            positions.push_back(Json::array({r.x, r.y, 0.0}));
        }
        samples.push_back(
            Json{{"t", static_cast<double>(k) / trace.sample_hz}, {"r", std::move(positions)}});
    }
    return samples;
}

}  // namespace

Result<Scene, SceneError> scene_from_json(const Json& json) {
    wire::Reading reading;
    Scene scene;
    if (wire::SceneCodec{}.read(wire::Cursor(json, reading), scene)) return scene;
    return SceneError{std::move(reading.error->pointer), std::move(reading.error->reason)};
}

Json to_json(const Scene& scene) {
    return wire::SceneCodec{}.write(scene, kExact);
}

Json to_json(const ShotEvent& event, const Scene& scene) {
    Json ids = Json::array();
    for (std::size_t i = 0; i < event.ball_count; ++i)
        ids.push_back(scene.balls[event.balls[i].value].id);
    Json object{{"t", event.t}, {"kind", name(event.kind)}, {"balls", std::move(ids)}};
    if (event.kind == EventKind::kBallRail) object["rail"] = name(event.rail);
    if (event.kind == EventKind::kBallPocket) object["pocket"] = name(event.pocket);
    object["at"] = place_json(event);
    object["before"] = states_json(event, event.before, scene);
    object["after"] = states_json(event, event.after, scene);
    return object;
}

Json to_json(const ShotTrace& trace, const Scene& scene) {
    Json events = Json::array();
    for (const ShotEvent& event : trace.events)
        events.push_back(to_json(event, scene));
    Json balls = Json::array();
    for (std::size_t i = 0; i < trace.balls.size(); ++i) {
        balls.push_back(final_ball_json(trace.balls[i], scene.balls[i].id));
    }
    Json result{{"schema", "poolhall.result/1"},  {"id", scene.id},
                {"solver", name(trace.solver)},   {"kernel", trace.kernel},
                {"hash", to_hex(trace.hash)},     {"duration", trace.duration},
                {"outcome", name(trace.outcome)}, {"events", std::move(events)},
                {"balls", std::move(balls)}};
    if (trace.sample_hz > 0) result["samples"] = samples_json(trace);
    return result;
}

}  // namespace poolhall::protocol
