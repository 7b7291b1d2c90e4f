#pragma once

#include "shared/math/vec3.hpp"
#include "shared/physics/scene/scene.hpp"

namespace poolhall {

struct CueBallMotion {
    Vec3 v;  ///< m/s; z is not positive
    Vec3 w;  ///< rad/s
};

/// The motion of a ball of that radius (m) right after the strike, before the slate acts: a cue
/// that slopes down leaves v.z < 0, which becomes a bounce or nothing.
///
/// The speed is the strike's. The spin is w = (5 / (2 R^2)) offset x v with v along the cue
/// (Alciatore, TP A.12): right english turns the ball counterclockwise seen from above. The end of
/// the cue deflects v from the cue's line, away from the english (squirt, TP A.31).
[[nodiscard]] CueBallMotion strike_motion(const Strike& strike, Real radius);

/// The tangent of the angle of squirt, with the sign of `side` (radii, shorter than 1):
/// (5/2) b sqrt(1 - b^2) / (1 + 1/m + (5/2)(1 - b^2)), where m is the effective end mass of the cue
/// over the ball's mass; m = 0 gives none; pooltool takes 1/30. Alciatore, TP A.31.
[[nodiscard]] Real squirt_tangent(Real side, Real end_mass_ratio);

}  // namespace poolhall
