#include "client/lab/validate/validate_results.hpp"

#include <iomanip>
#include <limits>

namespace poolhall::lab {

namespace {

/// A cell of text: in quotes, which it has none of.
std::string quoted(const std::string& text) {
    return '"' + text + '"';
}

void put(std::ostream& out, const std::optional<double>& value) {
    out << ',';
    if (value) out << *value;
}

void write_table(std::ostream& out, const MeasuredTable& table) {
    for (std::size_t model = 0; model < table.models.size(); ++model) {
        const auto begin = [&](const std::string& row) {
            out << table.name << ',' << quoted(row) << ',' << quoted(table.unit) << ','
                << quoted(table.models[model]);
        };
        for (const MeasuredRow& row : table.rows) {
            begin(row.what);
            out << ',' << row.published.low << ',' << row.published.high;
            put(out, row.ours[model]);
            put(out, error_of(table, row, model));
            out << ',' << (row.is_outlier ? "yes" : "no") << '\n';
        }
        const TableErrors errors = errors_of(table, model);
        begin("rms");
        out << ",,,";
        put(out, errors.rms);
        out << ",\n";
        if (!errors.rms_without_outliers) continue;
        begin("rms without outliers");
        out << ",,,";
        put(out, errors.rms_without_outliers);
        out << ",\n";
    }
}

void write_shots(std::ostream& out, const std::string& model, const char* shots,
                 const ShotsFound& found) {
    const auto write = [&](const char* what, double value) {
        out << "recorded," << quoted(std::string(shots) + ": " + what) << ",\"m\"," << quoted(model)
            << ",0,0," << value << ',' << value << ",no\n";
    };
    write("whole shot, p25", found.whole.p25);
    write("whole shot, median", found.whole.median);
    write("whole shot, p75", found.whole.p75);
    write("cue ball to third rail, p25", found.to_third_rail.p25);
    write("cue ball to third rail, median", found.to_third_rail.median);
    write("cue ball to third rail, p75", found.to_third_rail.p75);
}

}  // namespace

void write_csv(std::ostream& out, const ValidateResult& result) {
    out << std::setprecision(std::numeric_limits<double>::max_digits10)
        << "table,row,unit,model,published_low,published_high,ours,error,outlier\n";
    for (const MeasuredTable& table : result.tables)
        write_table(out, table);
    for (const RecordedResult& one : result.recorded) {
        write_shots(out, one.model, "even, constants not fitted", one.unfitted);
        write_shots(out, one.model, "odd, fitted", one.odd);
        write_shots(out, one.model, "even, fitted to odd", one.even);
    }
}

}  // namespace poolhall::lab
