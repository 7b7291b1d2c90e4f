#include "client/compare/contenders.hpp"

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
double time_of(Simulator& simulator, const Scene& scene, const ContestRules& rules,
               ShotTrace& trace) {
    double spent = 0;
    double shortest = 0;
    for (int i = 0; i < rules.repeats; ++i) {
        const double begin = cpu_time_ns();
        simulator.simulate(scene, 0, trace);
        const double passed = cpu_time_ns() - begin;
        shortest = i == 0 ? passed : std::min(shortest, passed);
        spent += passed;
        if (spent > rules.patience_ns) break;
    }
    return shortest;
}

Contender contender_of(Simulator& simulator, const Scene& scene, const ContestRules& rules) {
    Contender contender;
    contender.solver = scene.solver;
    contender.refusal = check(scene);
    if (contender.refusal) return contender;
    ShotTrace& trace = contender.trace;
    simulator.simulate(scene, 0, trace);
    contender.cpu_ns = time_of(simulator, scene, rules, trace);
    simulator.simulate(scene, affordable_hz(trace, rules.sample_hz), trace);
    return contender;
}

/// The event solver is exact; among the others more ticks are better.
double accuracy_of(const SolverSpec& solver) {
    return solver.kind == SolverKind::kEvent ? 2 * kMaxSolverHz : solver.hz;
}

std::optional<std::size_t> most_accurate(const std::vector<Contender>& contenders) {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < contenders.size(); ++i) {
        if (contenders[i].refusal) continue;
        if (!best || accuracy_of(contenders[i].solver) > accuracy_of(contenders[*best].solver))
            best = i;
    }
    return best;
}

}  // namespace

Contest contest(Scene scene, std::span<const SolverSpec> solvers, const ContestRules& rules) {
    Contest contest;
    Simulator simulator;
    for (const SolverSpec& solver : solvers) {
        scene.solver = solver;
        contest.contenders.push_back(contender_of(simulator, scene, rules));
    }
    contest.reference = most_accurate(contest.contenders);
    for (Contender& contender : contest.contenders) {
        if (contender.refusal) continue;
        const ShotTrace& reference = contest.contenders[*contest.reference].trace;
        contender.rest_distance = analysis::rest_distances(contender.trace, reference);
        contender.agreement = analysis::agreement(reference, contender.trace);
    }
    return contest;
}

std::string label(const SolverSpec& solver) {
    const std::string kind(name(solver.kind));
    return solver.kind == SolverKind::kEvent ? kind : kind + formatted(":%g", solver.hz);
}

std::optional<FarthestBall> farthest_ball(const Contender& contender) {
    const auto& distances = contender.rest_distance;
    const auto farthest = std::max_element(distances.begin(), distances.end());
    if (farthest == distances.end()) return std::nullopt;
    return FarthestBall{BallIndex{static_cast<std::uint16_t>(farthest - distances.begin())},
                        *farthest};
}

}  // namespace poolhall::compare
