#include "client/lab/compare/comparison_text.hpp"

#include "client/compare/number_text.hpp"
#include "client/lab/input/scene_source.hpp"
#include "client/lab/output/columns.hpp"
#include "shared/analysis/agreement.hpp"

#include <algorithm>

namespace poolhall::lab {

namespace {

using compare::Contender;
using compare::Contest;
using compare::formatted;
using compare::text_of_cost;
using compare::text_of_distance;

const Contender& reference_of(const Contest& contest) {
    return contest.contenders[*contest.reference];
}

std::vector<std::string> event_cells(const Scene& scene, const Contender& contender) {
    std::vector<std::string> cells{"  " + compare::label(contender.solver)};
    if (contender.refusal) {
        cells.push_back("  refused: " + text_of(*contender.refusal));
        return cells;
    }
    for (std::size_t i = 0; i < contender.trace.events.size(); ++i) {
        const ShotEvent& event = contender.trace.events[i];
        cells.push_back((contender.agreement.instead == i ? "* " : "  ") +
                        formatted("%.9f  ", event.t) + analysis::in_words(scene, event));
    }
    return cells;
}

std::string difference_of(const Scene& scene, const Contest& contest, const Contender& contender) {
    if (contender.refusal) return "refused: " + text_of(*contender.refusal);
    const Contender& reference = reference_of(contest);
    if (&contender == &reference) return "the reference: the others are compared with it";
    const std::string difference =
        analysis::first_difference(scene, contender.agreement, reference.trace, contender.trace,
                                   compare::label(contender.solver));
    return difference.empty() ? "the same events" : difference;
}

}  // namespace

void print_events(std::ostream& out, const Scene& scene, const Contest& contest) {
    std::vector<std::vector<std::string>> columns;
    columns.reserve(contest.contenders.size());
    std::size_t longest = 0;
    for (const Contender& contender : contest.contenders) {
        columns.push_back(event_cells(scene, contender));
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

void print_differences(std::ostream& out, const Scene& scene, const Contest& contest) {
    Columns lines;
    for (const Contender& contender : contest.contenders)
        lines.add(
            {"  " + compare::label(contender.solver), difference_of(scene, contest, contender)});
    out << "First difference from " << compare::label(reference_of(contest).solver) << "\n\n";
    lines.print(out);
}

void print_rest_distances(std::ostream& out, const Scene& scene, const Contest& contest) {
    Columns lines;
    std::vector<std::string> head{"  ball"};
    for (const Contender& contender : contest.contenders)
        head.push_back(compare::label(contender.solver));
    lines.add(std::move(head));
    for (std::size_t ball = 0; ball < scene.balls.size(); ++ball) {
        std::vector<std::string> line{"  " + scene.balls[ball].id};
        for (const Contender& contender : contest.contenders)
            line.push_back(contender.refusal ? "-"
                                             : text_of_distance(contender.rest_distance[ball]));
        lines.add(std::move(line));
    }
    out << "At rest, distance from " << compare::label(reference_of(contest).solver) << "\n\n";
    lines.print(out);
}

void print_costs(std::ostream& out, const Contest& contest) {
    Columns lines;
    lines.add({"  solver", "CPU time", "ticks", "events", "ended", "kernel"});
    for (const Contender& contender : contest.contenders) {
        if (contender.refusal) continue;
        const ShotTrace& trace = contender.trace;
        lines.add({"  " + compare::label(contender.solver), text_of_cost(contender.cpu_ns),
                   std::to_string(trace.ticks), std::to_string(trace.events.size()),
                   std::string(name(trace.outcome)) + formatted(" at %.3f s", trace.duration),
                   std::string(trace.kernel)});
    }
    out << "Cost of the shot, CPU time of one thread, the shortest of "
        << compare::ContestRules{}.repeats << " runs\n\n";
    lines.print(out);
}

}  // namespace poolhall::lab
