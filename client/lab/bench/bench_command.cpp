#include "client/lab/bench/bench_command.hpp"

#include "client/compare/number_text.hpp"
#include "client/files/output_file.hpp"
#include "client/lab/bench/bench_rows.hpp"
#include "client/lab/corpora/corpora.hpp"
#include "client/lab/output/build_info.hpp"
#include "client/lab/run/long_run.hpp"
#include "shared/physics/scene/trace.hpp"

#include <optional>

namespace poolhall::lab {

namespace {

/// Four significant digits.
std::string text_of(double value) {
    return compare::formatted("%.4g", value);
}

std::string padded(const std::string& text, std::size_t width) {
    return text + std::string(text.size() < width ? width - text.size() : 1, ' ');
}

/// The ratio to another's value; more is better for rates, less for all else.
std::string compared(const BenchRow& row, const Reference& reference) {
    if (!(row.value > 0)) return "";
    const bool more_is_better = row.unit == "shots/s";
    const double ratio = row.value / reference.value;
    const double advantage = more_is_better ? ratio : 1 / ratio;
    return advantage >= 1 ? text_of(advantage) + " times better here"
                          : text_of(1 / advantage) + " times worse here";
}

void print_row(std::ostream& out, const BenchRow& row) {
    out << padded(row.name, 34) << padded(text_of(row.value), 12) << padded(row.unit, 14)
        << padded(row.instructions ? text_of(*row.instructions) : "-", 12)
        << (row.wrong ? "WRONG: " : "") << row.check << '\n';
    for (const Reference& reference : row.references) {
        out << padded("", 4) << padded(reference.program, 30)
            << padded(text_of(reference.value), 12) << compared(row, reference) << '\n';
    }
    out << std::flush;
}

void print_titles(std::ostream& out, const BuildInfo& info) {
    print_head(out, "poolhall-lab bench", info);
    out << '\n'
        << padded("name", 34) << padded("value", 12) << padded("unit", 14)
        << padded("instructions", 12) << " checked\n";
}

std::string quoted(const std::string& text) {
    return '"' + text + '"';
}

void write_csv(std::ostream& out, const BuildInfo& info, const std::vector<BenchRow>& rows) {
    out << "name,value,unit,instructions,right,check,against,against_value,compiler,flags,"
           "processor\n";
    for (const BenchRow& row : rows) {
        auto references = row.references;
        if (references.empty()) references.push_back({});
        for (const Reference& reference : references) {
            out << row.name << ',' << text_of(row.value) << ',' << row.unit << ','
                << (row.instructions ? text_of(*row.instructions) : "") << ','
                << (row.wrong ? "no" : "yes") << ',' << quoted(row.check) << ','
                << reference.program << ','
                << (reference.program.empty() ? "" : text_of(reference.value)) << ','
                << quoted(info.compiler) << ',' << quoted(info.flags) << ','
                << quoted(info.processor) << '\n';
        }
    }
}

}  // namespace

Status bench(const std::string& csv_file, std::ostream& out, std::ostream& error) {
    const bool csv_only = csv_file == "-";
    std::optional<files::OutputFile> csv;
    if (!csv_file.empty() && !csv_only) csv.emplace(csv_file);
    if (csv && csv->fault()) return fail(error, *csv->fault());
    const BuildInfo info = build_info();
    if (!csv_only) print_titles(out, info);
    std::vector<BenchRow> rows;
    bool wrong = false;
    for (const BenchGroup& group : bench_groups()) {
        for (BenchRow& row : group.run()) {
            if (!csv_only) print_row(out, row);
            wrong = wrong || row.wrong;
            rows.push_back(std::move(row));
        }
    }
    if (csv_only) write_csv(out, info, rows);
    if (csv) {
        write_csv(csv->stream(), info, rows);
        csv->finish();
        if (csv->fault()) return fail(error, *csv->fault());
    }
    return wrong ? Status::kWrong : Status::kGood;
}

Status print_hashes(std::ostream& out) {
    for (const Corpus& corpus : corpora())
        out << corpus.name << ' ' << to_hex(hash_of(corpus)) << std::endl;
    return Status::kGood;
}

}  // namespace poolhall::lab
