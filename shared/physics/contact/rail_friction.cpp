#include "shared/physics/contact/rail_friction.hpp"

namespace poolhall {

RailFriction::Forces RailFriction::cloth_at_rest(Vec2 nose) const {
    const Vec2 at_nose = mu_nose_ * nose;
    const Vec2 needed = needed_at_cloth(at_nose);
    const Real has = mu_cloth_ * load(at_nose);
    const Real size = norm(needed);
    return {at_nose, size > has ? (has / size) * needed : needed};
}

bool RailFriction::cloth_holds(Vec2 nose) const {
    const Vec2 at_nose = mu_nose_ * nose;
    return norm(needed_at_cloth(at_nose)) <= mu_cloth_ * load(at_nose);
}

RailFriction::Forces RailFriction::nose_at_rest(Vec2 cloth) const {
    const Vec2 pressed = limited_at_nose(mu_cloth_ * cloth);
    if (load(pressed) > 0) return {pressed, (mu_cloth_ * load(pressed)) * cloth};
    return {limited_at_nose({}), {}};
}

bool RailFriction::nose_holds(Vec2 cloth) const {
    return norm(needed_at_nose(mu_cloth_ * cloth, 0)) <= mu_nose_;
}

RailFriction::Forces RailFriction::stop_nose(Vec2 slip, Vec2 cloth) const {
    const Vec2 per_load = mu_cloth_ * cloth;
    const Vec2 impulse = nose_friction(slip, per_load, 0);
    return {impulse, (c_ * impulse.y) * per_load};
}

Vec2 RailFriction::needed_at_nose(Vec2 cloth_per_load, Real damping) const {
    const Vec2 drive = nose_slip(1, {{}, s_ * cloth_per_load});
    return nose_friction(drive, cloth_per_load, damping);
}

Vec2 RailFriction::nose_friction(Vec2 slip, Vec2 cloth_per_load, Real damping) const {
    const Real yy = 2.5 + s_ * s_ + (2.5 - s_) * c_ * cloth_per_load.y;
    const Real y = slip.y / (yy + damping);
    return {(slip.x - (1 - 2.5 * s_) * c_ * cloth_per_load.x * y) / (3.5 + damping), y};
}

// If the friction that keeps the slip at zero is too much, slip begins in the direction of the
// friction f, at a rate of damping * f: |f| = mu and (M + damping) f = drive. Newton's method on
// 1/|f| = 1/mu, which is nearly linear in the damping, climbs to it from below. A very rough cloth
// (mu near 1) can make M singular: start beyond that.
Vec2 RailFriction::limited_at_nose(Vec2 cloth_per_load) const {
    constexpr int kIterations = 6;
    Real damping = std::max(Real{0}, -2 - (2.5 - s_) * c_ * cloth_per_load.y);
    Vec2 f = needed_at_nose(cloth_per_load, damping);
    Real size = norm(f);
    if (size <= mu_nose_) return f;
    for (int i = 0; i < kIterations; ++i) {
        const Real slope = dot(f, nose_friction(f, cloth_per_load, damping));
        damping += size * size * (size - mu_nose_) / (mu_nose_ * slope);
        f = needed_at_nose(cloth_per_load, damping);
        size = norm(f);
    }
    return (mu_nose_ / size) * f;
}

}  // namespace poolhall
