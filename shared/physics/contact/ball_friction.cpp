#include "shared/physics/contact/ball_friction.hpp"

#include "shared/math/elementary.hpp"

namespace poolhall {

BallFriction::BallFriction(const BallBallSpec& spec) {
    if (!has_friction(spec)) return;
    if (spec.friction_by_speed) {
        a_ = spec.friction_by_speed->a;
        b_ = spec.friction_by_speed->b;
        c_ = spec.friction_by_speed->c;
    } else {
        a_ = spec.mu;
    }
}

Real BallFriction::coefficient(Real slip_speed) const {
    return b_ == 0 ? a_ : a_ + b_ * elementary::exp(-c_ * slip_speed);
}

Vec3 slip_velocity(Vec3 n, const ImpactBall& a, const ImpactBall& b) {
    // Sums in which a and b change places with no bit changed: balls have no order.
    const Vec3 v = a.v - b.v;
    const Vec3 surface = cross(a.radius * a.w + b.radius * b.w, n);
    return (v - dot(v, n) * n) + surface;
}

Vec3 friction_impulse(const BallFriction& friction, Real normal_impulse, Vec3 n,
                      const ImpactBall& a, const ImpactBall& b) {
    const Vec3 slip = slip_velocity(n, a, b);
    const Real speed = norm(slip);
    const Real most = friction.coefficient(speed) * normal_impulse;
    // An impulse J changes the slip by J/m of translation and (R^2 / I) J = (5/2) J/m of spin, on
    // either ball: what ends it is the slip over (7/2)(1/m_a + 1/m_b).
    const Real effective_mass = Real{2} / 7 * (a.mass * b.mass) / (a.mass + b.mass);
    if (speed * effective_mass <= most) return effective_mass * slip;
    return most / speed * slip;
}

void apply_tangential(Vec3 impulse, Vec3 n, VerticalPart vertical, ImpactBall& a, ImpactBall& b) {
    // Both balls are pushed opposite ways at opposite points: the torque is the same on both.
    const Vec3 torque = 2.5 * cross(impulse, n);
    a.w = a.w + 1 / (a.mass * a.radius) * torque;
    b.w = b.w + 1 / (b.mass * b.radius) * torque;
    if (vertical == VerticalPart::kToSlate) impulse.z = 0;
    a.v = a.v - 1 / a.mass * impulse;
    b.v = b.v + 1 / b.mass * impulse;
}

}  // namespace poolhall
