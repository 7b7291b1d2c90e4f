#include "shared/physics/scene/scene_checks.hpp"

namespace poolhall::scene_checks {

namespace {

/// Parted by no more than this, pressed balls stay together to the eye.
constexpr Real kMaxSeparation = 1;  ///< m/s

/// The effects with one coefficient of friction.
template <class Spec>
MaybeError check_friction(const std::optional<Spec>& spec, const std::string& effect) {
    if (!spec) return std::nullopt;
    return in_range(spec->mu, 0, kMaxFriction, "/effects/" + effect + "/mu");
}

MaybeError check_drag(const std::optional<LinearDragSpec>& drag) {
    if (!drag) return std::nullopt;
    if (auto error = in_range(drag->k, 0, kMaxSolverHz, "/effects/linear_drag/k")) return error;
    return in_range(drag->stop_speed, 0, kMaxSpeed, "/effects/linear_drag/stop_speed");
}

MaybeError check_ball_ball(const BallBallSpec& spec) {
    const std::string pointer = "/effects/ball_ball";
    if (auto error = in_range(spec.e, 0, 1, pointer + "/e")) return error;
    if (auto error = in_range(spec.mu, 0, kMaxFriction, pointer + "/mu")) return error;
    if (auto error = in_range(spec.min_separation, 0, kMaxSeparation, pointer + "/min_separation"))
        return error;
    if (!spec.friction_by_speed) return std::nullopt;
    const auto [a, b, c] = *spec.friction_by_speed;
    if (auto error = in_range(a, 0, kMaxFriction, pointer + "/friction_by_speed/a")) return error;
    if (auto error = in_range(b, 0, kMaxFriction, pointer + "/friction_by_speed/b")) return error;
    return in_range(c, 0, kMaxSpeed, pointer + "/friction_by_speed/c");
}

bool has_nose(RailModel model) {
    return model != RailModel::kElastic && model != RailModel::kRestitution;
}

MaybeError check_rail(const Scene& scene) {
    const RailSpec& rail = scene.effects.rail;
    if (auto error = in_range(rail.e, 0, 1, "/effects/rail/e")) return error;
    if (auto error = in_range(rail.mu, 0, kMaxFriction, "/effects/rail/mu")) return error;
    const std::string pointer = "/effects/rail/nose_height";
    if (auto error = positive(rail.nose_height, kMaxLength, pointer)) return error;
    if (!has_nose(rail.model) || !scene.table.rails) return std::nullopt;
    bool below_top = rail.nose_height < 2 * scene.ball.radius;
    for (const SceneBall& ball : scene.balls)
        below_top = below_top && rail.nose_height < 2 * radius_of(scene, ball);
    if (below_top) return std::nullopt;
    return SceneError{pointer, "must be below the top of every ball"};
}

}  // namespace

MaybeError check_effects(const Scene& scene) {
    const Effects& effects = scene.effects;
    if (auto error = check_drag(effects.linear_drag)) return error;
    if (auto error = check_friction(effects.sliding, "sliding")) return error;
    if (auto error = check_friction(effects.rolling, "rolling")) return error;
    if (auto error = check_friction(effects.spin_decay, "spin_decay")) return error;
    if (auto error = check_ball_ball(effects.ball_ball)) return error;
    if (auto error = check_rail(scene)) return error;
    if (!effects.airborne) return std::nullopt;
    return in_range(effects.airborne->e_slate, 0, 1, "/effects/airborne/e_slate");
}

}  // namespace poolhall::scene_checks
