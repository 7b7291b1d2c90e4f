#pragma once

#include "client/lab/accuracy/results.hpp"
#include "client/lab/ensembles/ensembles.hpp"
#include "client/lab/run/progress.hpp"
#include "client/lab/run/run_plan.hpp"

#include <optional>
#include <vector>

namespace poolhall::lab {

/// The solvers that take the scene: those with ticks at 15, 30, ... 7680 Hz (of a quick run 30 Hz
/// to the ensemble's highest), then `event`.
[[nodiscard]] std::vector<SolverSpec> solvers_for(const Ensemble& ensemble, Scene scene,
                                                  const RunPlan& plan);

/// First the errors of all shots by all solvers; then, apart from them, what a shot costs. Nothing
/// if it was interrupted.
[[nodiscard]] std::optional<EnsembleResult> run_ensemble(const Ensemble& ensemble,
                                                         const RunPlan& plan, Progress& progress);

}  // namespace poolhall::lab
