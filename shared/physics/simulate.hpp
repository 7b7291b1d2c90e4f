#pragma once

#include "shared/physics/scene.hpp"
#include "shared/physics/trace.hpp"

namespace poolhall {

/// Rate at which shots are shown and broadcast, 1/s.
inline constexpr double kPlayoutHz = 30;

/// Simulates the scene from its strike (or from the balls' own velocities) until nothing moves or a
/// limit is reached. `sample_hz` > 0 also fills trace.samples with positions at k / sample_hz, k =
/// 0, 1, ... up to the first at or after the end. The trace is overwritten; its memory is used
/// again. The scene must have passed check().
void simulate(const Scene& scene, double sample_hz, ShotTrace& trace);

[[nodiscard]] ShotTrace simulate(const Scene& scene, double sample_hz = 0);

}  // namespace poolhall
