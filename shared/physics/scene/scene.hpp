#pragma once

#include "shared/fields.hpp"
#include "shared/physics/effects/all_effects.hpp"
#include "shared/physics/motion/cue.hpp"
#include "shared/physics/scene/solver_spec.hpp"
#include "shared/table/ball.hpp"
#include "shared/table/table.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace poolhall {

/// check() (shared/physics/check.hpp) refuses more.
inline constexpr std::size_t kMaxBalls = 1024;

struct Limits {
    Real time = 600;                ///< s of simulated time
    std::uint32_t events = 100000;  ///< of every kind

    static constexpr double kMaxTime = 1e6;  ///< s
    static constexpr std::uint32_t kMaxEvents = 10'000'000;

    static constexpr auto field_list() {
        return std::tuple{
            fields::of("time", &Limits::time, fields::positive(kMaxTime)).in("s").or_default(),
            fields::of("events", &Limits::events, {1, kMaxEvents}).or_default()};
    }

    friend constexpr bool operator==(const Limits&, const Limits&) = default;
};

struct SceneBall {
    std::string id;
    BallState state;
    std::optional<Real> radius = {};  ///< m, where it differs from Scene::ball
    std::optional<Real> mass = {};    ///< kg, where it differs from Scene::ball

    static constexpr auto field_list() {
        constexpr fields::Bounds kVelocities{-kMaxSpeed, kMaxSpeed};
        return std::tuple{
            fields::of("id", &SceneBall::id, kIdBytes),
            fields::of(
                "r", [](auto& ball) -> auto& { return ball.state.r; }, kPlaces)
                .in("m")
                .or_in_plane(),
            fields::of(
                "v", [](auto& ball) -> auto& { return ball.state.v; }, kVelocities)
                .in("m/s")
                .or_in_plane()
                .or_default(),
            fields::of("w", [](auto& ball) -> auto& { return ball.state.w; }, {-kMaxSpin, kMaxSpin})
                .in("rad/s")
                .or_default(),
            fields::of("radius", &SceneBall::radius, fields::positive(kMaxLength)).in("m"),
            fields::of("mass", &SceneBall::mass, fields::positive(kMaxLength)).in("kg")};
    }

    friend bool operator==(const SceneBall&, const SceneBall&) = default;
};

/// All that determines a shot. The same scene gives the same trace to the last bit, everywhere.
struct Scene {
    std::string id;
    Table table;
    BallSpec ball;
    Real gravity = 9.81;  ///< m/s^2
    Effects effects;
    SolverSpec solver;
    std::vector<SceneBall> balls;
    Limits limits;
    std::optional<Strike> strike;

    static constexpr auto field_list() {
        return std::tuple{
            fields::of("id", &Scene::id, {0, kMaxIdBytes}).or_default(),
            fields::of("table", &Scene::table),
            fields::of("ball", &Scene::ball).or_default(),
            fields::of("gravity", &Scene::gravity, {0, kMaxLength}).in("m/s^2").or_default(),
            fields::of("effects", &Scene::effects),
            fields::of("solver", &Scene::solver),
            fields::of("balls", &Scene::balls, {0, kMaxBalls}),
            fields::of("limits", &Scene::limits).or_default(),
            fields::of("strike", &Scene::strike)};
    }

    friend bool operator==(const Scene&, const Scene&) = default;
};

struct SceneError {
    std::string pointer;  ///< JSON pointer into the scene's file form, "/balls/1/r"
    std::string reason;   ///< one sentence without a full stop
};

/// Of a ball of the scene, m and kg.
[[nodiscard]] inline Real radius_of(const Scene& scene, const SceneBall& ball) {
    return ball.radius.value_or(scene.ball.radius);
}

[[nodiscard]] inline Real mass_of(const Scene& scene, const SceneBall& ball) {
    return ball.mass.value_or(scene.ball.mass);
}

[[nodiscard]] std::optional<BallIndex> find_ball(const Scene& scene, std::string_view id);

/// Hash of all that determines the shot, ids of balls and pockets included: two machines that agree
/// on it simulate the same.
[[nodiscard]] std::uint64_t hash_of(const Scene& scene);

}  // namespace poolhall
