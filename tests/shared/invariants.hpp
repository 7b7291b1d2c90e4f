#pragma once

#include "shared/physics/simulate.hpp"

#include <string>

namespace poolhall::testing {

/// Kinetic energy of a solid sphere over its mass, m^2/s^2.
[[nodiscard]] double energy_of(const BallState& state, double radius);

/// What in this trace no shot may show, or nothing: a number that is not finite, events out of
/// order, momentum of an impact that changes by more than 4 ulp a ball, energy that rises by more
/// than the least separation speed may give, samples in which balls are off the table or overlap by
/// more than `tolerance` (m).
[[nodiscard]] std::string broken_invariant(const Scene& scene, const ShotTrace& trace,
                                           double tolerance);

}  // namespace poolhall::testing
