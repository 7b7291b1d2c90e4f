#pragma once

#include "shared/physics/scene/scene.hpp"
#include "shared/physics/scene/trace.hpp"

namespace poolhall::lab {

/// The shot of one ball that rolls (effect `rolling` and no other, no strike, no pockets) between
/// elastic rails, in closed form: unfolded at the rails, the table's images tile the plane, and the
/// ball goes straight on with deceleration mu g for v^2 / (2 mu g) m. So the n-th rail needs no
/// rail before it, and nothing adds up. In 113 bits; the trace has the nearest doubles, its kernel
/// and hash are empty. Samples as in Simulator::simulate().
void unfold(const Scene& scene, double sample_hz, ShotTrace& trace);

}  // namespace poolhall::lab
