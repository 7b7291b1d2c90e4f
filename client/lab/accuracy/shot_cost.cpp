#include "client/lab/accuracy/shot_cost.hpp"

#include "shared/physics/simulate.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace poolhall::lab {

namespace {

constexpr std::size_t kMostTimedShots = 100;

/// CPU time of the scene's first `time` s, ns.
double cost_until(Scene scene, double time, const Repeats& repeats) {
    if (time <= 0) return 0;
    scene.limits.time = time;
    Simulator simulator;
    ShotTrace trace;
    return measure([&] { simulator.simulate(scene, 0, trace); }, repeats).ns;
}

/// Windows are short, and two of them are taken for each point.
Repeats for_windows(const Repeats& repeats) {
    return {repeats.count, repeats.least_ns / 10};
}

double cost_of_window(const Scene& scene, double begin, double end, const Repeats& repeats) {
    return std::max(cost_until(scene, end, repeats) - cost_until(scene, begin, repeats), 0.0);
}

double worst_tick(Scene scene, const SolverSpec& solver, const Window& busiest,
                  const Repeats& repeats) {
    scene.solver = solver;
    const double first = cost_of_window(scene, 0, window_length(solver), repeats);
    if (busiest.begin == 0) return first;
    return std::max(first, cost_of_window(scene, busiest.begin, busiest.end, repeats));
}

}  // namespace

double window_length(const SolverSpec& solver) {
    constexpr double kHz = kPlayoutHz;
    return 1 / (has_ticks(solver.kind) ? std::min(kHz, solver.hz) : kHz);
}

void note_busiest(const ShotTrace& trace, const SolverSpec& solver, std::size_t shot,
                  Window& busiest) {
    const double length = window_length(solver);
    auto first = trace.events.begin();
    while (first != trace.events.end()) {
        const double window = std::floor(first->t / length);
        const double end = (window + 1) * length;
        const auto last = std::find_if(first + 1, trace.events.end(),
                                       [end](const ShotEvent& event) { return event.t >= end; });
        const auto events = static_cast<std::size_t>(last - first);
        if (events > busiest.events) busiest = {shot, window * length, end, events};
        first = last;
    }
}

ShotCost cost_of_shots(std::span<const Scene> shots, const SolverSpec& solver, double ns_a_shot,
                       const Window& busiest, const Repeats& repeats) {
    const auto affordable =
        static_cast<std::size_t>(std::max(repeats.least_ns / std::max(ns_a_shot, 1.0), 1.0));
    const std::size_t count = std::min({shots.size(), kMostTimedShots, affordable});
    std::vector<Scene> timed(shots.begin(), shots.begin() + static_cast<std::ptrdiff_t>(count));
    for (Scene& scene : timed)
        scene.solver = solver;
    Simulator simulator;
    ShotTrace trace;
    const Cost cost = measure(
        [&] {
            for (const Scene& scene : timed)
                simulator.simulate(scene, 0, trace);
        },
        repeats);
    const auto of_one = [&](double sum) { return sum / static_cast<double>(count); };
    ShotCost result;
    result.ns = of_one(cost.ns);
    if (cost.instructions) result.instructions = of_one(*cost.instructions);
    result.worst_tick_ns = worst_tick(shots[busiest.shot], solver, busiest, for_windows(repeats));
    return result;
}

}  // namespace poolhall::lab
