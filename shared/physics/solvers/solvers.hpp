#pragma once

#include "shared/physics/solvers/shot_run.hpp"

#include <cstddef>

// Each solver with each kernel, in a translation unit a solver. `kernel` is a place in KernelList
// that covers the run's scene.
namespace poolhall {

void run_euler(std::size_t kernel, ShotRun& run);
void run_semi_implicit(std::size_t kernel, ShotRun& run);
void run_exact_arc(std::size_t kernel, ShotRun& run);
void run_event(std::size_t kernel, ShotRun& run);
void run_overlap(std::size_t kernel, ShotRun& run);

}  // namespace poolhall
