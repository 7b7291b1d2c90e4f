#include "client/lab/compare/comparison_text.hpp"

#include "client/compare/number_text.hpp"
#include "client/lab/input/scene_source.hpp"
#include "client/lab/output/columns.hpp"
#include "shared/analysis/agreement.hpp"

#include <algorithm>

namespace poolhall::lab {

namespace {

using compare::Comparison;
using compare::formatted;
using compare::SolverRun;
using compare::text_of_cost;
using compare::text_of_distance;

const SolverRun& reference_of(const Comparison& comparison) {
    return comparison.runs[*comparison.reference];
}

std::vector<std::string> event_cells(const Scene& scene, const SolverRun& run) {
    std::vector<std::string> cells{"  " + compare::label(run.solver)};
    if (run.refusal) {
        cells.push_back("  refused: " + text_of(*run.refusal));
        return cells;
    }
    for (std::size_t i = 0; i < run.trace.events.size(); ++i) {
        const ShotEvent& event = run.trace.events[i];
        cells.push_back((run.agreement.instead == i ? "* " : "  ") + formatted("%.9f  ", event.t) +
                        analysis::in_words(scene, event));
    }
    return cells;
}

std::string difference_of(const Scene& scene, const Comparison& comparison, const SolverRun& run) {
    if (run.refusal) return "refused: " + text_of(*run.refusal);
    const SolverRun& reference = reference_of(comparison);
    if (&run == &reference) return "the reference: the others are compared with it";
    const std::string difference = analysis::first_difference(
        scene, run.agreement, reference.trace, run.trace, compare::label(run.solver));
    return difference.empty() ? "the same events" : difference;
}

}  // namespace

void print_events(std::ostream& out, const Scene& scene, const Comparison& comparison) {
    std::vector<std::vector<std::string>> columns;
    columns.reserve(comparison.runs.size());
    std::size_t longest = 0;
    for (const SolverRun& run : comparison.runs) {
        columns.push_back(event_cells(scene, run));
        longest = std::max(longest, columns.back().size());
    }
    Columns lines;
    for (std::size_t i = 0; i < longest; ++i) {
        std::vector<std::string> line;
        line.reserve(columns.size());
        for (const auto& cells : columns)
            line.push_back(i < cells.size() ? cells[i] : "");
        lines.add(std::move(line));
    }
    out << "Events, times in s\n\n";
    lines.print(out);
}

void print_differences(std::ostream& out, const Scene& scene, const Comparison& comparison) {
    Columns lines;
    for (const SolverRun& run : comparison.runs)
        lines.add({"  " + compare::label(run.solver), difference_of(scene, comparison, run)});
    out << "First difference from " << compare::label(reference_of(comparison).solver) << "\n\n";
    lines.print(out);
}

void print_rest_distances(std::ostream& out, const Scene& scene, const Comparison& comparison) {
    Columns lines;
    std::vector<std::string> head{"  ball"};
    for (const SolverRun& run : comparison.runs)
        head.push_back(compare::label(run.solver));
    lines.add(std::move(head));
    for (std::size_t ball = 0; ball < scene.balls.size(); ++ball) {
        std::vector<std::string> line{"  " + scene.balls[ball].id};
        for (const SolverRun& run : comparison.runs)
            line.push_back(run.refusal ? "-" : text_of_distance(run.rest_distance[ball]));
        lines.add(std::move(line));
    }
    out << "At rest, distance from " << compare::label(reference_of(comparison).solver) << "\n\n";
    lines.print(out);
}

void print_costs(std::ostream& out, const Comparison& comparison) {
    Columns lines;
    lines.add({"  solver", "CPU time", "ticks", "events", "ended", "kernel"});
    for (const SolverRun& run : comparison.runs) {
        if (run.refusal) continue;
        const ShotTrace& trace = run.trace;
        lines.add({"  " + compare::label(run.solver), text_of_cost(run.cpu_ns),
                   std::to_string(trace.ticks), std::to_string(trace.events.size()),
                   std::string(name(trace.outcome)) + formatted(" at %.3f s", trace.duration),
                   std::string(trace.kernel)});
    }
    out << "Cost of the shot, CPU time of one thread, the shortest of "
        << compare::ComparisonLimits{}.repeats << " runs\n\n";
    lines.print(out);
}

}  // namespace poolhall::lab
