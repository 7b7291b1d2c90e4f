#include "shared/physics/scene.hpp"

#include <cmath>

namespace poolhall {

namespace {

// Bounds wide enough for any experiment that makes sense, narrow enough that squares stay finite.
constexpr double kMaxLength = 1e6;  ///< m
constexpr double kMaxSpeed = 1e6;   ///< m/s
constexpr double kMaxSpin = 1e9;    ///< rad/s
constexpr double kMaxTime = 1e6;    ///< s
constexpr double kMaxTicks = 1e9;   ///< what a minute or so can simulate
constexpr std::uint32_t kMaxEvents = 10'000'000;

using MaybeError = std::optional<SceneError>;

/// Not (low <= x <= high) also catches NaN.
MaybeError in_range(double x, double low, double high, const std::string& pointer) {
    if (x >= low && x <= high) return std::nullopt;
    return SceneError{pointer, "must be a finite number within its bounds"};
}

MaybeError positive(double x, double high, const std::string& pointer) {
    if (x > 0 && x <= high) return std::nullopt;
    return SceneError{pointer, "must be positive and within its bounds"};
}

MaybeError vector_in_range(const Vec3& a, double bound, const std::string& pointer) {
    if (auto error = in_range(a.x, -bound, bound, pointer + "/0")) return error;
    if (auto error = in_range(a.y, -bound, bound, pointer + "/1")) return error;
    return in_range(a.z, -bound, bound, pointer + "/2");
}

MaybeError check_table(const Scene& scene) {
    if (auto error = positive(scene.table.length, kMaxLength, "/table/length")) return error;
    if (auto error = positive(scene.table.width, kMaxLength, "/table/width")) return error;
    if (auto error = positive(scene.ball.radius, kMaxLength, "/ball/radius")) return error;
    if (auto error = positive(scene.ball.mass, kMaxLength, "/ball/mass")) return error;
    if (auto error = in_range(scene.gravity, 0, kMaxLength, "/gravity")) return error;
    const double least = 4 * scene.ball.radius;
    if (scene.table.length < least || scene.table.width < least) {
        return SceneError{"/table",
                          "is too small for its balls: both sides need at least two diameters"};
    }
    if (scene.table.pockets != PocketModel::kNone && !scene.table.rails) {
        return SceneError{"/table/pockets", "needs a table with rails"};
    }
    return std::nullopt;
}

MaybeError check_effects(const Scene& scene) {
    const double hz = scene.solver.hz;
    if (auto error = in_range(hz, kMinSolverHz, kMaxSolverHz, "/solver/hz")) return error;
    if (auto error = in_range(scene.effects.rail.e, 0, 1, "/effects/rail/e")) return error;
    if (!scene.effects.linear_drag) return std::nullopt;
    const LinearDragSpec& drag = *scene.effects.linear_drag;
    if (auto error = in_range(drag.k, 0, kMaxSolverHz, "/effects/linear_drag/k")) return error;
    if (auto error = in_range(drag.stop_speed, 0, kMaxSpeed, "/effects/linear_drag/stop_speed"))
        return error;
    if (drag.k >= hz)
        return SceneError{"/effects/linear_drag/k",
                          "must be below the solver's hz: an Euler step would turn the ball round"};
    return std::nullopt;
}

MaybeError check_strike(const Scene& scene) {
    if (!scene.strike) return std::nullopt;
    const Strike& strike = *scene.strike;
    if (strike.ball.value >= scene.balls.size())
        return SceneError{"/strike/ball", "names no ball of the scene"};
    const auto [x, y] = strike.direction;
    if (!std::isfinite(x) || !std::isfinite(y))
        return SceneError{"/strike/direction", "must be finite"};
    if (x == 0 && y == 0) return SceneError{"/strike/direction", "must not be zero"};
    return in_range(strike.speed, 0, kMaxSpeed, "/strike/speed");
}

/// Inside the rails, as far as rounding goes.
bool on_table(const Scene& scene, Vec2 r) {
    if (!scene.table.rails) return true;
    const Vec2 edge = inset(scene.table, scene.ball.radius);
    return std::abs(r.x) <= edge.x + kTouchTolerance && std::abs(r.y) <= edge.y + kTouchTolerance;
}

MaybeError check_ball(const Scene& scene, std::size_t i) {
    const std::string pointer = "/balls/" + std::to_string(i);
    const SceneBall& ball = scene.balls[i];
    if (ball.id.empty() || ball.id.size() > kMaxIdBytes)
        return SceneError{pointer + "/id", "must have 1 to 64 bytes"};
    if (auto error = vector_in_range(ball.state.r, kMaxLength, pointer + "/r")) return error;
    if (auto error = vector_in_range(ball.state.v, kMaxSpeed, pointer + "/v")) return error;
    if (auto error = vector_in_range(ball.state.w, kMaxSpin, pointer + "/w")) return error;
    if (!on_table(scene, xy(ball.state.r))) return SceneError{pointer + "/r", "is off the table"};
    const double touching = 2 * scene.ball.radius - kTouchTolerance;
    for (std::size_t j = 0; j < i; ++j) {
        const Vec2 gap = xy(ball.state.r) - xy(scene.balls[j].state.r);
        if (ball.id == scene.balls[j].id)
            return SceneError{pointer + "/id",
                              "is the same as /balls/" + std::to_string(j) + "/id"};
        if (norm(gap) < touching)
            return SceneError{pointer + "/r", "overlaps /balls/" + std::to_string(j)};
    }
    return std::nullopt;
}

}  // namespace

std::optional<SceneError> check(const Scene& scene) {
    if (auto error = check_table(scene)) return error;
    if (auto error = check_effects(scene)) return error;
    if (auto error = positive(scene.limits.time, kMaxTime, "/limits/time")) return error;
    if (scene.limits.time * scene.solver.hz > kMaxTicks)
        return SceneError{"/limits/time", "must be at most a billion ticks of the solver"};
    if (scene.limits.events == 0 || scene.limits.events > kMaxEvents)
        return SceneError{"/limits/events", "must be 1 to 10000000"};
    if (scene.balls.size() > kMaxBalls) return SceneError{"/balls", "must be at most 1024"};
    for (std::size_t i = 0; i < scene.balls.size(); ++i) {
        if (auto error = check_ball(scene, i)) return error;
    }
    return check_strike(scene);
}

std::optional<BallIndex> find_ball(const Scene& scene, std::string_view id) {
    for (std::size_t i = 0; i < scene.balls.size(); ++i) {
        if (scene.balls[i].id == id) return BallIndex{static_cast<std::uint16_t>(i)};
    }
    return std::nullopt;
}

}  // namespace poolhall
