#pragma once

#include "client/lab/accuracy/results.hpp"
#include "client/lab/ensembles/ensembles.hpp"

#include <span>
#include <vector>

namespace poolhall::lab {

/// How the distance from the true place grows within a shot, for a few solvers at rates that people
/// use: over the first shots of the ensemble, up to the median of their durations. Goes on early if
/// interrupted.
[[nodiscard]] std::vector<ErrorInTime> errors_in_time(const Ensemble& ensemble,
                                                      std::span<const Scene> scenes);

}  // namespace poolhall::lab
