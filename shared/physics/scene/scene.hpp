#pragma once

#include "shared/table/ball.hpp"
#include "shared/table/table.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace poolhall {

/// The parameters of the effects that a scene calls for; what is absent is not simulated, and a
/// coefficient of 0 means the same as absent.
struct LinearDragSpec {
    Real k = 0.6;              ///< 1/s: v' = -k v
    Real stop_speed = 0.0625;  ///< m/s: slower than this is at rest

    friend constexpr bool operator==(const LinearDragSpec&, const LinearDragSpec&) = default;
};

struct SlidingSpec {
    Real mu = 0.2;  ///< friction of the cloth on a ball that slips

    friend constexpr bool operator==(const SlidingSpec&, const SlidingSpec&) = default;
};

struct RollingSpec {
    Real mu = 0.01;  ///< rolling resistance: deceleration over gravity

    friend constexpr bool operator==(const RollingSpec&, const RollingSpec&) = default;
};

struct SpinDecaySpec {
    Real mu = 0.0127;  ///< spin about the vertical axis falls with 5 mu g / (2 R)

    friend constexpr bool operator==(const SpinDecaySpec&, const SpinDecaySpec&) = default;
};

enum class BallBallModel : std::uint8_t {
    kElastic,      ///< e = 1, no friction
    kRestitution,  ///< e
    kFriction,     ///< e and friction: throw
};

/// Friction between balls that falls with the speed of their slip: mu = a + b exp(-c u).
/// Defaults: Alciatore, TP A.14 (billiards.colostate.edu), fitted to Marlow's measurements.
struct FrictionBySpeed {
    Real a = 9.951e-3;
    Real b = 0.108;
    Real c = 1.088;  ///< s/m

    friend constexpr bool operator==(const FrictionBySpeed&, const FrictionBySpeed&) = default;
};

struct BallBallSpec {
    BallBallModel model = BallBallModel::kElastic;
    Real e = 0.95;   ///< coefficient of restitution, 0 to 1; not used by kElastic
    Real mu = 0.05;  ///< friction between balls; used by kFriction
    std::optional<FrictionBySpeed> friction_by_speed;  ///< instead of mu
    /// Balls that cloth friction can press together leave an impact at least this fast, m/s.
    Real min_separation = 1e-4;

    friend constexpr bool operator==(const BallBallSpec&, const BallBallSpec&) = default;
};

enum class RailModel : std::uint8_t {
    kElastic,
    kRestitution,
    kHan2005,
    kMathavan2010,
    kMathavan2010Fast,  ///< fewer steps, for many shots
};

struct RailSpec {
    RailModel model = RailModel::kElastic;
    Real e = 1;     ///< coefficient of restitution, 0 to 1; not used by kElastic
    Real mu = 0.2;  ///< friction between ball and rail; used by Han's and Mathavan's models
    Real nose_height = 0.036576;  ///< of the rail's nose above the cloth, m; for the same

    friend constexpr bool operator==(const RailSpec&, const RailSpec&) = default;
};

struct AirborneSpec {
    Real e_slate = 0.5;  ///< coefficient of restitution of ball and slate, 0 to 1

    friend constexpr bool operator==(const AirborneSpec&, const AirborneSpec&) = default;
};

struct Effects {
    std::optional<LinearDragSpec> linear_drag;
    std::optional<SlidingSpec> sliding;
    std::optional<RollingSpec> rolling;
    std::optional<SpinDecaySpec> spin_decay;
    BallBallSpec ball_ball;
    RailSpec rail;
    std::optional<AirborneSpec> airborne;

    friend constexpr bool operator==(const Effects&, const Effects&) = default;
};

enum class SolverKind : std::uint8_t {
    kEuler,    ///< explicit Euler, contacts by swept time of impact
    kOverlap,  ///< explicit Euler, contacts by the overlap found at the end of a tick; it misses
               ///< some
    kSemiImplicit,  ///< semi-implicit Euler: velocities before places
    kExactArc,      ///< closed-form motion inside each tick, contacts on its chord
    kEvent,         ///< closed-form motion from event to event; no tick at all
};

struct SolverSpec {
    SolverKind kind = SolverKind::kEuler;
    Real hz = 30;  ///< ticks a second; not used by kEvent

    friend constexpr bool operator==(const SolverSpec&, const SolverSpec&) = default;
};

struct Limits {
    Real time = 600;                ///< s of simulated time
    std::uint32_t events = 100000;  ///< of every kind

    friend constexpr bool operator==(const Limits&, const Limits&) = default;
};

struct SceneBall {
    std::string id;
    BallState state;
    std::optional<Real> radius = {};  ///< m, where it differs from Scene::ball
    std::optional<Real> mass = {};    ///< kg, where it differs from Scene::ball

    friend bool operator==(const SceneBall&, const SceneBall&) = default;
};

/// The blow of the cue. A direction, never an angle: nothing has to be evaluated by a trigonometric
/// function, here or on another machine.
struct Strike {
    BallIndex ball;
    Vec2 direction{1, 0};  ///< of any length but zero
    Real speed = 0;        ///< of the ball right after it, m/s
    /// Where the tip hits, seen along the cue: [side, vertical] in radii, shorter than 1. Side > 0
    /// is right english, vertical > 0 follow.
    Vec2 offset = {};
    Real elevation = 0;  ///< slope of the cue: how far it falls per metre of horizontal way
    /// Effective end mass of the cue over the ball's mass: what deflects the cue ball (squirt).
    Real end_mass_ratio = 0;

    friend constexpr bool operator==(const Strike&, const Strike&) = default;
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

    friend bool operator==(const Scene&, const Scene&) = default;
};

/// Bounds of what a scene may hold; check() refuses the rest.
inline constexpr std::size_t kMaxBalls = 1024;
inline constexpr std::size_t kMaxIdBytes = 64;
inline constexpr Real kMinSolverHz = 1;
inline constexpr Real kMaxSolverHz = 1e6;
/// Balls that overlap by no more than this are taken as touching, m.
inline constexpr Real kTouchTolerance = 1e-9;

struct SceneError {
    std::string pointer;  ///< JSON pointer into the scene's file form, "/balls/1/r"
    std::string reason;   ///< one sentence without a full stop
};

/// The first thing that is wrong with the scene: not finite, out of range, unknown ball, overlap.
[[nodiscard]] std::optional<SceneError> check(const Scene& scene);

/// Of a ball of the scene, m and kg.
[[nodiscard]] inline Real radius_of(const Scene& scene, const SceneBall& ball) {
    return ball.radius.value_or(scene.ball.radius);
}

[[nodiscard]] inline Real mass_of(const Scene& scene, const SceneBall& ball) {
    return ball.mass.value_or(scene.ball.mass);
}

[[nodiscard]] std::optional<BallIndex> find_ball(const Scene& scene, std::string_view id);

}  // namespace poolhall
