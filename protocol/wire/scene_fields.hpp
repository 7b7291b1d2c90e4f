#pragma once

#include "protocol/wire/codecs.hpp"
#include "shared/physics/scene/scene.hpp"

#include <string>
#include <tuple>

// The fields of poolhall.scene/1. Ranges are left to check(), so that a scene is judged alike
// wherever it came from.
namespace poolhall::protocol::wire {

inline constexpr std::string_view kSceneSchema = "poolhall.scene/1";

/// The direction of a strike: two numbers, or three of which the last points down.
struct StrikeDirection {
    [[nodiscard]] bool read(const Cursor& cursor, Vec3& value) const;

    [[nodiscard]] Json write(const Vec3& value, Encoding encoding) const {
        return Vector2{}.write(xy(value), encoding);
    }
};

/// "none", "end_game", "pool", or a list of circles: Table::pockets and Table::circles.
struct PocketsCodec {
    [[nodiscard]] bool read(const Cursor& cursor, Table& table) const;
    [[nodiscard]] Json write(const Table& table, Encoding encoding) const;
};

/// A strike as it is written: by the ball's id.
struct StrikeForm {
    std::string ball;
    Vec3 direction;  ///< z < 0 is another way to give the elevation; never written
    double speed = 0;
    Vec2 offset;
    double elevation = 0;
    double end_mass_ratio = 0;
};

template <>
inline constexpr auto kFields<PocketCircle> = std::tuple{
    field("id", &PocketCircle::id, Text{1, kMaxIdBytes}),
    field(
        "x", [](auto& circle) -> auto& { return circle.centre.x; }, SceneReal{}),
    field(
        "y", [](auto& circle) -> auto& { return circle.centre.y; }, SceneReal{}),
    field("radius", &PocketCircle::radius, SceneReal{}),
};

template <>
inline constexpr auto kFields<Table> = std::tuple{
    field("length", &Table::length, SceneReal{}),
    field("width", &Table::width, SceneReal{}),
    field("rails", &Table::rails).or_default(),
    field(
        "pockets", [](auto& table) -> auto& { return table; }, PocketsCodec{})
        .or_default(),
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
inline constexpr auto kFields<SlidingSpec> = std::tuple{
    field("mu", &SlidingSpec::mu, SceneReal{}).or_default(),
};

template <>
inline constexpr auto kFields<RollingSpec> = std::tuple{
    field("mu", &RollingSpec::mu, SceneReal{}).or_default(),
};

template <>
inline constexpr auto kFields<SpinDecaySpec> = std::tuple{
    field("mu", &SpinDecaySpec::mu, SceneReal{}).or_default(),
};

template <>
inline constexpr auto kFields<FrictionBySpeed> = std::tuple{
    field("a", &FrictionBySpeed::a, SceneReal{}).or_default(),
    field("b", &FrictionBySpeed::b, SceneReal{}).or_default(),
    field("c", &FrictionBySpeed::c, SceneReal{}).or_default(),
};

template <>
inline constexpr auto kFields<BallBallSpec> = std::tuple{
    field("model", &BallBallSpec::model),
    field("e", &BallBallSpec::e, SceneReal{}).or_default(),
    field("mu", &BallBallSpec::mu, SceneReal{}).or_default(),
    field("friction_by_speed", &BallBallSpec::friction_by_speed),
    field("min_separation", &BallBallSpec::min_separation, SceneReal{}).or_default(),
};

template <>
inline constexpr auto kFields<RailSpec> = std::tuple{
    field("model", &RailSpec::model),
    field("e", &RailSpec::e, SceneReal{}).or_default(),
    field("mu", &RailSpec::mu, SceneReal{}).or_default(),
    field("nose_height", &RailSpec::nose_height, SceneReal{}).or_default(),
};

template <>
inline constexpr auto kFields<AirborneSpec> = std::tuple{
    field("e_slate", &AirborneSpec::e_slate, SceneReal{}).or_default(),
};

template <>
inline constexpr auto kFields<Effects> = std::tuple{
    field("linear_drag", &Effects::linear_drag),
    field("sliding", &Effects::sliding),
    field("rolling", &Effects::rolling),
    field("spin_decay", &Effects::spin_decay),
    field("ball_ball", &Effects::ball_ball).or_default(),
    field("rail", &Effects::rail).or_default(),
    field("airborne", &Effects::airborne),
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
    field("radius", &SceneBall::radius, SceneReal{}),
    field("mass", &SceneBall::mass, SceneReal{}),
};

template <>
inline constexpr auto kFields<Limits> = std::tuple{
    field("time", &Limits::time, SceneReal{}).or_default(),
    field("events", &Limits::events).or_default(),
};

template <>
inline constexpr auto kFields<StrikeForm> = std::tuple{
    field("ball", &StrikeForm::ball, Text{1, kMaxIdBytes}),
    field("direction", &StrikeForm::direction, StrikeDirection{}),
    field("speed", &StrikeForm::speed, SceneReal{}),
    field("offset", &StrikeForm::offset, SceneVector2{}).or_default(),
    field("elevation", &StrikeForm::elevation, SceneReal{}).or_default(),
    field("end_mass_ratio", &StrikeForm::end_mass_ratio, SceneReal{}).or_default(),
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
