#pragma once

#include "shared/math/vec3.hpp"
#include "shared/physics/contact/rail_contact.hpp"

namespace poolhall {

/// Impact on a rail after Inhwan Han, "Dynamics in Carom and Three Cushion Billiards", Journal of
/// Mechanical Science and Technology 19(4), 2005, eqs 14 to 22, in closed form: Newton's
/// restitution along the line from the nose to the ball's centre, and there Coulomb friction, which
/// ends the slip if it can. v m/s, w rad/s.
///
/// The inclined nose takes part of the restitution: without friction v_n becomes
/// (sin^2 theta - e cos^2 theta) v_n, theta being the nose's angle above the centre. The cloth
/// takes the vertical impulse and no friction; mu_table and mass do not matter. About 40 ns, 250
/// instructions (tests/bench, rail_impact).
void bounce_han2005(const RailContact& rail, Vec3& v, Vec3& w);

}  // namespace poolhall
