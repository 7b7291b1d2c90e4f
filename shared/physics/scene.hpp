#pragma once

#include "shared/table/ball.hpp"
#include "shared/table/table.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace poolhall {

/// The parameters of the effects that a scene calls for; what is absent is not simulated.
struct LinearDragSpec {
    double k = 0.6;              ///< 1/s: v' = -k v
    double stop_speed = 0.0625;  ///< m/s: slower than this is at rest

    friend constexpr bool operator==(const LinearDragSpec&, const LinearDragSpec&) = default;
};

enum class BallBallModel : std::uint8_t { kElastic };

struct BallBallSpec {
    BallBallModel model = BallBallModel::kElastic;

    friend constexpr bool operator==(const BallBallSpec&, const BallBallSpec&) = default;
};

enum class RailModel : std::uint8_t { kElastic, kRestitution };

struct RailSpec {
    RailModel model = RailModel::kElastic;
    double e = 1;  ///< coefficient of restitution, 0 to 1; used by kRestitution

    friend constexpr bool operator==(const RailSpec&, const RailSpec&) = default;
};

struct Effects {
    std::optional<LinearDragSpec> linear_drag;
    BallBallSpec ball_ball;
    RailSpec rail;

    friend constexpr bool operator==(const Effects&, const Effects&) = default;
};

enum class SolverKind : std::uint8_t {
    kEuler,    ///< explicit Euler, contacts by swept time of impact
    kOverlap,  ///< explicit Euler, contacts by the overlap found at the end of a tick; it misses
               ///< some
};

struct SolverSpec {
    SolverKind kind = SolverKind::kEuler;
    double hz = 30;  ///< ticks a second

    friend constexpr bool operator==(const SolverSpec&, const SolverSpec&) = default;
};

struct Limits {
    double time = 600;              ///< s of simulated time
    std::uint32_t events = 100000;  ///< of every kind

    friend constexpr bool operator==(const Limits&, const Limits&) = default;
};

struct SceneBall {
    std::string id;
    BallState state;

    friend bool operator==(const SceneBall&, const SceneBall&) = default;
};

/// The blow of the cue. A direction, never an angle: nothing has to be evaluated by a trigonometric
/// function, here or on another machine.
struct Strike {
    BallIndex ball;
    Vec2 direction{1, 0};  ///< of any length but zero
    double speed = 0;      ///< of the ball right after it, m/s

    friend constexpr bool operator==(const Strike&, const Strike&) = default;
};

/// All that determines a shot. The same scene gives the same trace to the last bit, everywhere.
struct Scene {
    std::string id;
    Table table;
    BallSpec ball;
    double gravity = 9.81;  ///< m/s^2
    Effects effects;
    SolverSpec solver;
    std::vector<SceneBall> balls;
    Limits limits;
    std::optional<Strike> strike;

    friend bool operator==(const Scene&, const Scene&) = default;
};

/// Bounds of what a scene may hold; check() refuses the rest.
inline constexpr std::size_t kMaxBalls = 1024;
inline constexpr std::size_t kMaxIdBytes = 64;
inline constexpr double kMinSolverHz = 1;
inline constexpr double kMaxSolverHz = 1e6;
/// Balls that overlap by no more than this are taken as touching, m.
inline constexpr double kTouchTolerance = 1e-9;

struct SceneError {
    std::string pointer;  ///< JSON pointer into the scene's file form, "/balls/1/r"
    std::string reason;   ///< one sentence without a full stop
};

/// The first thing that is wrong with the scene: not finite, out of range, unknown ball, overlap.
[[nodiscard]] std::optional<SceneError> check(const Scene& scene);

[[nodiscard]] std::optional<BallIndex> find_ball(const Scene& scene, std::string_view id);

}  // namespace poolhall
