#pragma once

#include "shared/physics/contact/ball_friction.hpp"

namespace poolhall {

/// What the impact of two balls on the cloth depends on besides their motion: 0 <= e, 0 <= mu,
/// mu_table.
struct BallsOnCloth {
    Real e = 1;         ///< coefficient of restitution
    Real mu = 0;        ///< friction between the balls
    Real mu_table = 0;  ///< friction between ball and cloth
    /// Of the estimated error of a step of the integration, relative to the speed of approach.
    Real tolerance = 1e-9;
};

/// Impact of two balls on the cloth after Mathavan, Jackson, Parkin, "Numerical simulations of the
/// frictional collisions of solid balls on a rough surface", Sports Eng. 17, 2014, 227-237 (and
/// Kim, arXiv:2402.13258): the vertical part of the friction between the balls presses one of them
/// on the cloth while they touch, where it slips too. n is the unit vector in the plane from a to
/// b, which must approach. v.z stays.
///
/// Integrated in the impulse along n by Dormand and Prince's fifth-order pair, until the balls have
/// got back e^2 of the work of compression. Error, relative to the speed of approach, mu up to 0.2
/// (AreIntegratedAsExactlyAsTheySay): median 4e-11, 99 % of impacts below 1e-8, all of 2500 below
/// 4e-8. Cost of an impact: about 8,600 instructions. The number of steps is bounded for any input.
void collide_mathavan2014(const BallsOnCloth& coefficients, Vec3 n, ImpactBall& a, ImpactBall& b);

}  // namespace poolhall
