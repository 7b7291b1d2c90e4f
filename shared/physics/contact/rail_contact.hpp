#pragma once

#include "shared/math/vec2.hpp"

namespace poolhall {

/// What an impact on a rail depends on besides the ball's motion. The nose must touch the ball on
/// its side, 0 < nose_height < 2 radius, and 0 <= e <= 1, 0 <= mu, mu_table: the scene's check sees
/// to it. The models of rails have no effect on a ball that does not approach, and leave v.z alone.
struct RailContact {
    Vec2 normal;           ///< unit, in the plane, from the table into the rail
    Real radius = 0;       ///< m
    Real mass = 0;         ///< kg
    Real nose_height = 0;  ///< of the rail's nose above the cloth, m
    Real e = 1;            ///< coefficient of restitution
    Real mu = 0;           ///< friction between ball and rail
    Real mu_table = 0;     ///< friction between ball and cloth, 0 if none
};

}  // namespace poolhall
