#include "client/compare/number_text.hpp"
#include "client/lab/output/columns.hpp"
#include "client/lab/validate/validate_results.hpp"

namespace poolhall::lab {

namespace {

using compare::formatted;
using compare::text_of_distance;

std::string decimal(double value, int digits) {
    const std::string format = "%." + std::to_string(digits) + "f";
    return formatted(format.c_str(), value);
}

std::string published(const MeasuredTable& table, const Published& value) {
    const std::string low = decimal(value.low, table.digits);
    return value.is_range() ? low + " to " + decimal(value.high, table.digits) : low;
}

/// An error, or an rms of errors, in the table's unit or in per cent.
std::string error_text(const MeasuredTable& table, double error, const char* sign) {
    if (table.is_relative)
        return formatted((std::string("%") + sign + ".1f %%").c_str(), 100 * error);
    const std::string format = std::string("%") + sign + "." + std::to_string(table.digits) + "f";
    return formatted(format.c_str(), error);
}

/// A line of the rms errors by model.
std::vector<std::string> rms_line(const MeasuredTable& table, const char* name,
                                  std::optional<double> TableErrors::*rms) {
    std::vector<std::string> line{name, ""};
    for (std::size_t model = 0; model < table.models.size(); ++model) {
        const auto value = errors_of(table, model).*rms;
        line.insert(line.end(), {"", value ? error_text(table, *value, "") : "-"});
    }
    return line;
}

std::string centimetres(const Quartiles& quartiles) {
    std::string text;
    for (const double value : {quartiles.p25, quartiles.median, quartiles.p75})
        text += (text.empty() ? "" : " / ") + formatted("%.1f", 100 * value);
    return text;
}

void add_shots(Columns& table, const char* name, const ShotsFound& found) {
    table.add({name, std::to_string(found.shots), centimetres(found.whole),
               centimetres(found.to_third_rail)});
}

}  // namespace

void print_table(std::ostream& out, const MeasuredTable& table) {
    out << '\n'
        << table.title << (table.unit.empty() ? "" : ", " + table.unit) << '\n'
        << "source: " << table.source << "; accuracy: " << table.accuracy << "\n\n";
    Columns columns(Columns::Align::kRight);
    std::vector<std::string> head{"", "published"};
    for (const std::string& model : table.models)
        head.insert(head.end(), {model, "error"});
    columns.add(head);
    bool has_outliers = false;
    for (const MeasuredRow& row : table.rows) {
        std::vector<std::string> line{row.what + (row.is_outlier ? " *" : ""),
                                      published(table, row.published)};
        has_outliers = has_outliers || row.is_outlier;
        for (std::size_t model = 0; model < table.models.size(); ++model) {
            const auto error = error_of(table, row, model);
            line.push_back(error ? decimal(*row.ours[model], table.digits) : "-");
            line.push_back(error ? error_text(table, *error, "+") : "-");
        }
        columns.add(line);
    }
    columns.add(rms_line(table, "rms", &TableErrors::rms));
    if (has_outliers)
        columns.add(rms_line(table, "rms without *", &TableErrors::rms_without_outliers));
    columns.print(out);
    if (!table.note.empty()) out << table.note << '\n';
}

void print_unknowns(std::ostream& out, const std::vector<Unknown>& unknowns) {
    out << "\nWhat is not known: how far the same shot moves\n\n";
    Columns table(Columns::Align::kRight);
    table.add(
        {"shots", "number", "balls 0.1 mm off: median", "90 %", "another table: median", "90 %"});
    for (const Unknown& one : unknowns)
        table.add({one.ensemble, std::to_string(one.shots), text_of_distance(one.placement.median),
                   text_of_distance(one.placement.p90), text_of_distance(one.coefficients.median),
                   text_of_distance(one.coefficients.p90)});
    table.print(out);
}

void print_horizons(std::ostream& out, const std::vector<HorizonByError>& horizons) {
    out << "\nHow long events are the same when balls are put down a little off, median\n\n";
    Columns table(Columns::Align::kRight);
    for (const HorizonByError& one : horizons) {
        for (std::size_t i = 0; i < one.input_error.size(); ++i)
            table.add({one.ensemble, formatted("%.0e m", one.input_error[i]),
                       formatted("%.2f s", one.horizon[i]),
                       formatted("of %.2f s", one.duration[i])});
    }
    table.print(out);
}

void print_recorded(std::ostream& out, const RecordedResult& result) {
    out << "\nRecorded shots, " << result.model << formatted("'s rail, %.0f s", result.seconds)
        << "\nroot mean square distances in cm, quartiles over shots\n\n";
    Columns table;
    table.add({"", "shots", "all balls, whole shot", "cue ball to its third rail"});
    add_shots(table, "even, constants not fitted", result.unfitted);
    add_shots(table, "odd, constants fitted to them", result.odd);
    add_shots(table, "even, constants fitted to the odd", result.even);
    table.print(out);
    for (const auto& [name, value] : result.constants)
        out << name << formatted(" %.4g  ", value);
    out << '\n';
}

}  // namespace poolhall::lab
