#pragma once

#include "shared/physics/scene/scene.hpp"
#include "shared/physics/scene/trace.hpp"

namespace poolhall {

/// Lays the scene's balls where the shot left them, at rest on the cloth. A shot that ended at a
/// limit stops there: who is on the way stays where it is then, and so does what flies. Spin that
/// nothing takes away ends too. The trace must be one of a scene with these balls.
void lay_at_rest(Scene& scene, const ShotTrace& trace);

/// Parts balls at rest that overlap by more than kTouchTolerance until they touch, so that the
/// scene passes its check() again; without any it changes nothing. A ball that flew over another at
/// the limit overlaps it once it is laid down.
void part_overlapping(Scene& scene);

}  // namespace poolhall
