#pragma once

#include "shared/physics/scene/trace.hpp"

#include <optional>

namespace poolhall::lab {

/// Of the first impact with a ball or a rail, against the reference's.
struct ImpactErrors {
    double time = 0;      ///< s
    double place = 0;     ///< m; of two balls the one that is farther off
    double velocity = 0;  ///< m/s, right after it; the same
};

/// One shot of a solver against its reference.
struct ShotErrors {
    double rest = 0;                     ///< m: of the ball that is farthest off at rest
    std::optional<ImpactErrors> impact;  ///< nothing where the first impacts are not the same
    double energy_drift = 0;             ///< the largest over the matching events
    double matching_events = 0;
    double horizon = 0;  ///< s
    bool verdict_flips = false;
    double missed = 0;    ///< impacts of balls
    double invented = 0;  ///< impacts of balls
};

[[nodiscard]] ShotErrors errors_of(const Scene& scene, const ShotTrace& reference,
                                   const ShotTrace& other);

}  // namespace poolhall::lab
