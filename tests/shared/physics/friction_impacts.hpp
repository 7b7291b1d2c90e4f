#pragma once

#include "shared/physics/contact/ball_friction.hpp"

// Impacts of two balls with friction, for the tests of its numbers and of its laws.
namespace poolhall::testing {

inline constexpr double kRadius = 0.028575;
inline constexpr double kMass = 0.170097;

inline BallFriction constant(double mu) {
    return BallFriction({.model = BallBallModel::kFriction, .mu = mu, .friction_by_speed = {}});
}

inline BallFriction by_speed() {
    return BallFriction(
        {.model = BallBallModel::kFriction, .friction_by_speed = FrictionBySpeed{}});
}

inline ImpactBall ball(Vec3 v = {}, Vec3 w = {}) {
    return {.v = v, .w = w, .radius = kRadius, .mass = kMass};
}

inline double normal_impulse(double e, Vec3 n, const ImpactBall& a, const ImpactBall& b) {
    return (1 + e) * dot(a.v - b.v, n) * (a.mass * b.mass) / (a.mass + b.mass);
}

inline void apply_normal(double impulse, Vec3 n, ImpactBall& a, ImpactBall& b) {
    a.v = a.v - impulse / a.mass * n;
    b.v = b.v + impulse / b.mass * n;
}

inline void apply_friction(const BallFriction& friction, double normal_impulse, Vec3 n,
                           ImpactBall& a, ImpactBall& b) {
    apply_tangential(friction_impulse(friction, normal_impulse, n, a, b), n, VerticalPart::kToSlate,
                     a, b);
}

inline void apply_friction_in_air(const BallFriction& friction, double normal_impulse, Vec3 n,
                                  ImpactBall& a, ImpactBall& b) {
    apply_tangential(friction_impulse(friction, normal_impulse, n, a, b), n, VerticalPart::kToBalls,
                     a, b);
}

}  // namespace poolhall::testing
