#pragma once

#include "protocol/wire/codecs.hpp"
#include "shared/physics/scene.hpp"

#include <string>
#include <tuple>

// The fields of poolhall.scene/1. Ranges are left to check(), so that a scene is judged alike
// wherever it came from.
namespace poolhall::protocol::wire {

inline constexpr std::string_view kSceneSchema = "poolhall.scene/1";

/// A strike as it is written: by the ball's id.
struct StrikeForm {
    std::string ball;
    Vec2 direction;
    double speed = 0;
};

template <>
inline constexpr auto kFields<Table> = std::tuple{
    field("length", &Table::length, SceneReal{}),
    field("width", &Table::width, SceneReal{}),
    field("rails", &Table::rails).or_default(),
    field("pockets", &Table::pockets).or_default(),
};

template <>
inline constexpr auto kFields<BallSpec> = std::tuple{
    field("radius", &BallSpec::radius, SceneReal{}),
    field("mass", &BallSpec::mass, SceneReal{}),
};

template <>
inline constexpr auto kFields<LinearDragSpec> = std::tuple{
    field("k", &LinearDragSpec::k, SceneReal{}),
    field("stop_speed", &LinearDragSpec::stop_speed, SceneReal{}),
};

template <>
inline constexpr auto kFields<BallBallSpec> = std::tuple{
    field("model", &BallBallSpec::model),
};

template <>
inline constexpr auto kFields<RailSpec> = std::tuple{
    field("model", &RailSpec::model),
    field("e", &RailSpec::e, SceneReal{}).or_default(),
};

template <>
inline constexpr auto kFields<Effects> = std::tuple{
    field("linear_drag", &Effects::linear_drag),
    field("ball_ball", &Effects::ball_ball).or_default(),
    field("rail", &Effects::rail).or_default(),
};

template <>
inline constexpr auto kFields<SolverSpec> = std::tuple{
    field("kind", &SolverSpec::kind),
    field("hz", &SolverSpec::hz, SceneReal{}).or_default(),
};

template <>
inline constexpr auto kFields<SceneBall> = std::tuple{
    field("id", &SceneBall::id, Text{1, kMaxIdBytes}),
    field(
        "r", [](auto& ball) -> auto& { return ball.state.r; }, Vector3{2}),
    field(
        "v", [](auto& ball) -> auto& { return ball.state.v; }, Vector3{2})
        .or_default(),
    field(
        "w", [](auto& ball) -> auto& { return ball.state.w; }, Vector3{3})
        .or_default(),
};

template <>
inline constexpr auto kFields<Limits> = std::tuple{
    field("time", &Limits::time, SceneReal{}).or_default(),
    field("events", &Limits::events).or_default(),
};

template <>
inline constexpr auto kFields<StrikeForm> = std::tuple{
    field("ball", &StrikeForm::ball, Text{1, kMaxIdBytes}),
    field("direction", &StrikeForm::direction, SceneVector2{}),
    field("speed", &StrikeForm::speed, SceneReal{}),
};

/// All but "schema" and "strike", which SceneCodec adds.
template <>
inline constexpr auto kFields<Scene> = std::tuple{
    field("id", &Scene::id, Text{0, kMaxIdBytes}).or_default(),
    field("table", &Scene::table),
    field("ball", &Scene::ball).or_default(),
    field("gravity", &Scene::gravity, SceneReal{}).or_default(),
    field("effects", &Scene::effects),
    field("solver", &Scene::solver),
    field("balls", &Scene::balls, List<Object<SceneBall>>{{}, kMaxBalls}),
    field("limits", &Scene::limits).or_default(),
};

/// A whole scene, check()ed.
struct SceneCodec {
    bool strike_required = false;

    [[nodiscard]] bool read(const Cursor& cursor, Scene& scene) const;
    [[nodiscard]] Json write(const Scene& scene, Encoding encoding) const;
};

}  // namespace poolhall::protocol::wire
