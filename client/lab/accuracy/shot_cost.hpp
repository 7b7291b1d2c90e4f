#pragma once

#include "client/lab/accuracy/results.hpp"
#include "client/lab/run/bench_clock.hpp"
#include "shared/physics/scene/trace.hpp"

#include <cstddef>
#include <optional>
#include <span>

namespace poolhall::lab {

/// A stretch of 1/30 s of simulated time; of one tick where ticks are longer.
struct Window {
    std::size_t shot = 0;
    double begin = 0;  ///< s
    double end = 0;    ///< s
    std::size_t events = 0;
};

/// How long windows are for a solver, s.
[[nodiscard]] double window_length(const SolverSpec& solver);

/// Notes a shot's busiest window if it has more events than `busiest`.
void note_busiest(const ShotTrace& trace, const SolverSpec& solver, std::size_t shot,
                  Window& busiest);

/// Times the first of the shots, as many as take about repeats.least_ns (`ns_a_shot` is a guess),
/// up to 100; and the worst window: the busiest one, or the first of its shot, in which the balls
/// are set up. A window costs what the shot up to its end does, less what the shot up to its
/// beginning does. `ticks` and `events` are left alone.
[[nodiscard]] ShotCost cost_of_shots(std::span<const Scene> shots, const SolverSpec& solver,
                                     double ns_a_shot, const Window& busiest,
                                     const Repeats& repeats);

}  // namespace poolhall::lab
