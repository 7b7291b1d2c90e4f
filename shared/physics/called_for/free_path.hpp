#pragma once

#include "shared/physics/motion/moving_ball.hpp"
#include "shared/physics/scene/scene.hpp"
#include "shared/physics/search/box.hpp"

#include <optional>

namespace poolhall {

/// The laws by which balls on the cloth come to rest, as bounds need them.
struct ClothLaws {
    explicit ClothLaws(const Scene& scene);

    Real slip = 0;  ///< deceleration of a ball that slips, m/s^2
    Real roll = 0;  ///< of one that rolls, m/s^2
    Real drag = 0;  ///< 1/s
    Real tick = 0;  ///< s; 0 where the solver has none
};

/// Where the surface of a ball on the cloth gets that meets nothing until it rests: a slide on a
/// parabola, which lies within its control polygon, then a straight roll (Sliding, Rolling), or
/// straight on (LinearDrag). Nothing where no law stops it. Steps of a stepping solver lag behind
/// by up to the change of velocity times a tick.
[[nodiscard]] std::optional<Box> free_path(const MovingBall& ball, const ClothLaws& cloth);

/// kg m a J: by how much the sum over all balls of mass times way to rest exceeds zero for a Joule
/// of their energy. A ball that rolls loses 7/5 m a J a metre (a its deceleration). One that slips
/// as well, v = V + 2/7 u, has the energy m (7/10 V^2 + u^2/7), slips for 2 u / (7 a_s) and comes
/// farther by at most V + u/7 times that. Infinity where no law stops it.
[[nodiscard]] Real way_for_energy(const ClothLaws& cloth);

/// J; with all of its spin, which impacts may turn into speed.
[[nodiscard]] Real kinetic_energy(const MovingBall& ball);

}  // namespace poolhall
