#include "client/lab/accuracy/accuracy_table.hpp"

#include "client/compare/comparison.hpp"
#include "client/compare/number_text.hpp"
#include "client/lab/output/columns.hpp"

namespace poolhall::lab {

namespace {

using compare::formatted;
using compare::label;

/// Three significant digits.
std::string short_text(double value) {
    return formatted("%.3g", value);
}

std::string per_cent(double share) {
    return formatted("%.1f %%", 100 * share);
}

/// A length in a unit that people read at a glance, or 0.
std::string length(double metres) {
    if (metres == 0) return "0";
    if (metres < 1e-9) return formatted("%.0e m", metres);
    if (metres < 1e-6) return formatted("%.3g nm", metres * 1e9);
    if (metres < 1e-3) return formatted("%.3g um", metres * 1e6);
    return metres < 1 ? formatted("%.3g mm", metres * 1e3) : formatted("%.3g m", metres);
}

std::string duration(double ns) {
    if (ns > 0 && ns < 1e-3) return formatted("%.0e s", ns / 1e9);
    if (ns < 1e3) return formatted("%.3g ns", ns);
    return ns < 1e6 ? formatted("%.3g us", ns / 1e3) : formatted("%.3g ms", ns / 1e6);
}

std::vector<std::string> line_of(const AccuracyPoint& point) {
    return {label(point.solver),
            duration(point.cost.ns),
            duration(point.cost.worst_tick_ns),
            length(point.rest_error.median),
            length(point.rest_error.p90),
            length(point.rest_error.max),
            point.impact_time_error ? duration(1e9 * point.impact_time_error->median) : "-",
            per_cent(point.matching_share),
            formatted("%.2f s", point.horizon_median),
            per_cent(point.verdict_flips),
            point.winner_flips ? per_cent(*point.winner_flips) : "-",
            short_text(point.missed),
            short_text(point.invented)};
}

std::vector<std::string> line_of(const OrderRow& row) {
    const std::string expected = formatted("%.0f", row.expected);
    if (!row.order)
        return {std::string(name(row.solver)), row.quantity, "-", "", "", expected, row.note};
    const auto& [order, low, high, points, from_hz, to_hz] = *row.order;
    return {std::string(name(row.solver)),
            row.quantity,
            formatted("%.3f", order),
            formatted("%.3f", low) + " to " + formatted("%.3f", high),
            formatted("%.0f", from_hz) + " to " + formatted("%.0f Hz", to_hz),
            expected,
            row.note};
}

/// A line for each place of the abscissa, with a value of each solver.
template <class Series, class Line>
void print_series(std::ostream& out, const std::string& abscissa, const std::vector<Series>& all,
                  std::size_t lines, Line cells) {
    Columns table(Columns::Align::kRight);
    std::vector<std::string> head{abscissa};
    for (const Series& one : all)
        head.push_back(label(one.solver));
    table.add(head);
    for (std::size_t i = 0; i < lines; ++i)
        table.add(cells(i));
    table.print(out);
}

}  // namespace

void print_table(std::ostream& out, const EnsembleResult& result) {
    out << '\n'
        << result.title << " (" << result.name << "): " << result.shots << " shots against "
        << result.reference << ", itself good to " << length(result.reference_error) << "\n\n";
    Columns points(Columns::Align::kRight);
    points.add({"solver", "CPU", "worst tick", "rest", "90 %", "max", "impact", "same", "until",
                "verdicts", "winners", "missed", "invented"});
    for (const AccuracyPoint& point : result.points)
        points.add(line_of(point));
    points.print(out);
    out << '\n';
    Columns orders;
    orders.add({"order of", "in", "fitted", "95 %", "over", "theory", ""});
    for (const OrderRow& row : result.orders)
        orders.add(line_of(row));
    orders.print(out);
    out << std::flush;
}

void print_table(std::ostream& out, const std::vector<Tunnelling>& all) {
    out << "\nTrue hits that are missed, by speed\n\n";
    print_series(out, "speed", all, all[0].speed.size(), [&](std::size_t i) {
        std::vector<std::string> line{short_text(all[0].speed[i]) + " m/s"};
        for (const Tunnelling& one : all)
            line.push_back(per_cent(one.missed[i]));
        return line;
    });
}

void print_table(std::ostream& out, const std::vector<CrowdCosts>& all) {
    out << "\nCPU time of a shot in which all balls move, the table in proportion\n\n";
    print_series(out, "balls", all, all[0].balls.size(), [&](std::size_t i) {
        std::vector<std::string> line{std::to_string(all[0].balls[i])};
        for (const CrowdCosts& one : all)
            line.push_back(duration(one.ns[i]));
        return line;
    });
}

}  // namespace poolhall::lab
