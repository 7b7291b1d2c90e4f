#include "client/compare/comparison.hpp"

#include "client/compare/cpu_time.hpp"
#include "client/compare/number_text.hpp"
#include "shared/physics/simulate.hpp"

#include <algorithm>

namespace poolhall::compare {

namespace {

/// The sample rate at which the trace's samples fit into kMaxPlaces.
double affordable_hz(const ShotTrace& trace, double wanted) {
    const double places = trace.duration * wanted * static_cast<double>(trace.balls.size());
    return places > kMaxPlaces ? wanted * kMaxPlaces / places : wanted;
}

/// CPU time of the shot, ns; leaves the trace without samples.
double time_of(Simulator& simulator, const Scene& scene, const ComparisonLimits& limits,
               ShotTrace& trace) {
    double spent = 0;
    double shortest = 0;
    for (int i = 0; i < limits.repeats; ++i) {
        const double begin = cpu_time_ns();
        simulator.simulate(scene, 0, trace);
        const double passed = cpu_time_ns() - begin;
        shortest = i == 0 ? passed : std::min(shortest, passed);
        spent += passed;
        if (spent > limits.max_cpu_ns) break;
    }
    return shortest;
}

SolverRun run_of(Simulator& simulator, const Scene& scene, const ComparisonLimits& limits) {
    SolverRun run;
    run.solver = scene.solver;
    run.refusal = check(scene);
    if (run.refusal) return run;
    ShotTrace& trace = run.trace;
    simulator.simulate(scene, 0, trace);
    run.cpu_ns = time_of(simulator, scene, limits, trace);
    simulator.simulate(scene, affordable_hz(trace, limits.sample_hz), trace);
    return run;
}

/// A solver without ticks is exact; among the others more ticks are better.
double accuracy_of(const SolverSpec& solver) {
    return has_ticks(solver.kind) ? solver.hz : 2 * kMaxSolverHz;
}

std::optional<std::size_t> most_accurate(const std::vector<SolverRun>& runs) {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        if (runs[i].refusal) continue;
        if (!best || accuracy_of(runs[i].solver) > accuracy_of(runs[*best].solver)) best = i;
    }
    return best;
}

}  // namespace

Comparison compare_solvers(Scene scene, std::span<const SolverSpec> solvers,
                           const ComparisonLimits& limits) {
    Comparison comparison;
    Simulator simulator;
    for (const SolverSpec& solver : solvers) {
        scene.solver = solver;
        comparison.runs.push_back(run_of(simulator, scene, limits));
    }
    comparison.reference = most_accurate(comparison.runs);
    for (SolverRun& run : comparison.runs) {
        if (run.refusal) continue;
        const ShotTrace& reference = comparison.runs[*comparison.reference].trace;
        run.rest_distance = analysis::rest_distances(run.trace, reference);
        run.agreement = analysis::agreement(reference, run.trace);
    }
    return comparison;
}

std::string label(const SolverSpec& solver) {
    const std::string kind(name(solver.kind));
    return has_ticks(solver.kind) ? kind + formatted(":%g", solver.hz) : kind;
}

std::optional<FarthestBall> farthest_ball(const SolverRun& run) {
    const auto& distances = run.rest_distance;
    const auto farthest = std::max_element(distances.begin(), distances.end());
    if (farthest == distances.end()) return std::nullopt;
    return FarthestBall{BallIndex{static_cast<std::uint16_t>(farthest - distances.begin())},
                        *farthest};
}

}  // namespace poolhall::compare
