#pragma once

#include "shared/physics/called_for/reach.hpp"
#include "shared/physics/effects/prospect.hpp"
#include "shared/physics/scene/scene.hpp"

#include <span>

namespace poolhall {

/// What may happen in the shot, by bounds that hold for every solver, before it is simulated.
/// `balls` are the scene's, in its order, after the strike. All may where the scene calls for an
/// effect of which the bounds know nothing: a force, or one that says `kGivesEnergy`.
[[nodiscard]] Prospect prospect_of(const Scene& scene, std::span<const MovingBall> balls,
                                   ReachMemory& memory);

/// Whether the ball can be left out of the simulation: it rests, and nobody gets to it.
[[nodiscard]] bool takes_no_part(const MovingBall& ball, const Prospect& prospect);

}  // namespace poolhall
