#pragma once

#include "shared/physics/shot_run.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace poolhall {

/// Two balls, or a ball and a rail, that touch and approach.
struct Contact {
    enum class Kind : std::uint8_t { kBalls, kRail };

    Kind kind = Kind::kBalls;
    std::size_t a = 0;
    std::size_t b = 0;         ///< kBalls
    Rail rail = Rail::kNorth;  ///< kRail
};

/// Changes the velocities of the balls whose contacts fall in the same instant, as one group:
/// generalized reflections (Smith, Kaufman, Vouga, Tamstorf, Grinspun, "Reflections on Simultaneous
/// Impact", SIGGRAPH 2012). Over the contacts that approach, the least impulses that stop them are
/// found together (a linear complementarity problem), then applied times 1 + e; again until none
/// approaches. Rails have restitution `e_rail` and infinite mass, balls are elastic and equal.
/// False if it does not come to an end (never seen).
[[nodiscard]] bool resolve(std::span<const Contact> contacts, double e_rail,
                           std::vector<MovingBall>& balls);

/// The unit vector from the table into the rail.
[[nodiscard]] Vec2 outward_normal(Rail rail);

}  // namespace poolhall
