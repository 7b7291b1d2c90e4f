#pragma once

#include "client/lab/accuracy/results.hpp"
#include "client/lab/bench_clock.hpp"
#include "client/lab/ensembles/ensembles.hpp"
#include "client/lab/progress.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace poolhall::lab {

/// How thorough a run is.
struct RunPlan {
    std::uint64_t seed = 1;
    bool quick = false;
    std::size_t shots = 0;  ///< of each ensemble; 0: what the ensemble says

    [[nodiscard]] Repeats repeats() const { return quick ? Repeats{3, 2e6} : Repeats{7, 2e7}; }
};

/// The solvers that take the scene: those with ticks at 15, 30, ... 7680 Hz (of a quick run 30 Hz
/// to the ensemble's highest), then `event`.
[[nodiscard]] std::vector<SolverSpec> solvers_for(const Ensemble& ensemble, Scene scene,
                                                  const RunPlan& plan);

/// First the errors of all shots by all solvers; then, apart from them, what a shot costs. Nothing
/// if it was interrupted.
[[nodiscard]] std::optional<EnsembleResult> run_ensemble(const Ensemble& ensemble,
                                                         const RunPlan& plan, Progress& progress);

}  // namespace poolhall::lab
