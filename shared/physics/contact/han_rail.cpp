#include "shared/physics/contact/han_rail.hpp"

#include "shared/physics/contact/rail_frame.hpp"

namespace poolhall {

void bounce_han2005(const RailContact& rail, Vec3& v, Vec3& w) {
    const BallAtRail ball(rail, v, w);
    if (!(ball.v.y > 0)) return;

    RailImpulse j;
    j.normal = (1 + rail.e) * ball.v.y * ball.cos_theta;  // eq 17
    const Vec2 slip = ball.nose_slip();                   // eq 14
    const Vec2 direction = normalized(slip);
    const Real to_stop = dot(slip, direction) / 3.5;  // eq 16: slip changes by 7/2 of an impulse
    const Real most = rail.mu * j.normal;
    j.nose = std::min(to_stop, most) * direction;  // eqs 18, 19
    apply(j, ball, rail, v, w);
}

}  // namespace poolhall
