#pragma once

#include "shared/math/vec2.hpp"
#include "shared/physics/scene/scene.hpp"

namespace poolhall {

/// How two balls meet. The impulse along the unit normal n from a to b makes them part at e times
/// the speed at which they approached; with equal masses and e = 1 they exchange the components
/// along n (text, 5.2.1). Friction between them is in ball_friction.hpp.
class BallBall {
  public:
    /// The coefficient of restitution.
    [[nodiscard]] static Real restitution(const Scene& scene) {
        return scene.effects.ball_ball.model == BallBallModel::kElastic ? 1
                                                                        : scene.effects.ball_ball.e;
    }

    [[nodiscard]] static bool has_friction(const Scene& scene) {
        const BallBallSpec& spec = scene.effects.ball_ball;
        return spec.model == BallBallModel::kFriction && (spec.friction_by_speed || spec.mu > 0);
    }
};

/// The velocities after the elastic impact of two equal balls, at the unit normal n from a to b.
inline void exchange_normal_velocity(Vec2& v_a, Vec2& v_b, Vec2 n) {
    const Vec2 impulse = dot(v_a - v_b, n) * n;
    v_a = v_a - impulse;
    v_b = v_b + impulse;
}

}  // namespace poolhall
