#include "client/compare/comparison.hpp"
#include "client/lab/accuracy/results.hpp"
#include "client/lab/output/csv_line.hpp"
#include "shared/physics/scene/trace.hpp"
#include "shared/physics/simulate.hpp"

#include <iomanip>
#include <limits>

namespace poolhall::lab {

namespace {

/// As CSV quotes text.
std::string quoted(const std::string& text) {
    return '"' + text + '"';
}

void write_spread_names(std::ostream& out, const char* quantity) {
    for (const char* part : {"median", "p90", "max"})
        out << ',' << quantity << '_' << part;
}

void write_head(std::ostream& out) {
    out << "ensemble,shots,reference,label,solver,hz,kernel,ns,instructions,worst_tick_ns,ticks,"
           "events";
    for (const char* quantity : {"rest_error", "impact_time_error", "impact_place_error",
                                 "impact_velocity_error", "energy_drift"})
        write_spread_names(out, quantity);
    out << ",matching_share,horizon_median,verdict_flips,winner_flips,missed,invented,seed,"
           "compiler,flags,cpu\n";
}

}  // namespace

void write_csv(std::ostream& out, const AccuracyResult& result) {
    out << std::setprecision(std::numeric_limits<double>::max_digits10);
    write_head(out);
    for (const EnsembleResult& ensemble : result.ensembles) {
        for (const AccuracyPoint& point : ensemble.points) {
            const bool ticks = has_ticks(point.solver.kind);
            CsvLine(out) << ensemble.name << ensemble.shots << quoted(ensemble.reference)
                         << compare::label(point.solver) << name(point.solver.kind)
                         << (ticks ? std::optional(point.solver.hz) : std::nullopt) << point.kernel
                         << point.cost.ns << point.cost.instructions << point.cost.worst_tick_ns
                         << point.cost.ticks << point.cost.events << point.rest_error
                         << point.impact_time_error << point.impact_place_error
                         << point.impact_velocity_error << point.energy_drift
                         << point.matching_share << point.horizon_median << point.verdict_flips
                         << point.winner_flips << point.missed << point.invented << result.seed
                         << quoted(result.build.compiler) << quoted(result.build.flags)
                         << quoted(result.build.processor);
            out << '\n';
        }
    }
}

}  // namespace poolhall::lab
