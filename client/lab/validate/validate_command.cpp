#include "client/lab/validate/validate_command.hpp"

#include "client/lab/output/result_files.hpp"
#include "client/lab/run/long_run.hpp"
#include "client/lab/run/progress.hpp"
#include "client/lab/validate/tables.hpp"
#include "client/lab/validate/validate_results.hpp"

#include <iterator>
#include <utility>

namespace poolhall::lab {

namespace {

constexpr std::uint64_t kSeed = 1;
constexpr std::size_t kBreaks = 500;
constexpr std::size_t kUnknownShots = 200;  ///< of each ensemble

template <class Item>
void append(std::vector<Item>& all, std::vector<Item> more) {
    all.insert(all.end(), std::make_move_iterator(more.begin()),
               std::make_move_iterator(more.end()));
}

std::vector<MeasuredTable> all_tables() {
    std::vector<MeasuredTable> tables;
    for (const auto make : {worked_value_tables, two_ball_tables, cushion_tables, cloth_tables,
                            cloth_and_cue_tables, pocket_tables, practice_tables})
        append(tables, make());
    append(tables, break_tables(kSeed, kBreaks));
    return tables;
}

std::vector<Figure> all_figures() {
    std::vector<Figure> figures;
    for (const auto make : {two_ball_figures, cushion_figures, cloth_and_cue_figures})
        append(figures, make());
    return figures;
}

/// The command line that gives the same again; the recording is the user's own.
std::string command_of(const ValidateOptions& options) {
    return std::string("poolhall-lab validate") +
           (options.recorded.empty() ? "" : " --recorded FILE");
}

/// Runs model after model; false if it was interrupted.
bool run_models(const std::vector<RecordedShot>& shots, const std::vector<RecordedModel>& models,
                Progress& progress, std::ostream& out, std::vector<RecordedResult>& results) {
    for (const RecordedModel& model : models) {
        auto found = run_recorded(shots, model, progress);
        progress.clear();
        if (!found) return false;
        print_recorded(out, *found);
        out.flush();
        results.push_back(std::move(*found));
    }
    return true;
}

}  // namespace

Status validate(const ValidateOptions& options, const std::vector<RecordedModel>& models,
                std::ostream& out, std::ostream& error) {
    std::vector<RecordedShot> shots;
    if (!options.recorded.empty()) {
        auto recording = read_recording(options.recorded);
        if (!recording) return fail(error, recording.error());
        shots = std::move(*recording);
    }
    ResultFiles files(options.out, "validate");
    if (files.fault()) return fail(error, *files.fault());
    const Interruption interruption;
    Progress progress(error, options.bar);
    ValidateResult result{.command = command_of(options),
                          .build = build_info(),
                          .tables = all_tables(),
                          .figures = all_figures(),
                          .unknowns = find_unknowns(kSeed, kUnknownShots),
                          .horizons = find_horizons(kSeed, kUnknownShots),
                          .recorded_shots = shots.size(),
                          .recorded = {}};
    print_head(out, result.command, result.build);
    for (const MeasuredTable& table : result.tables)
        print_table(out, table);
    print_unknowns(out, result.unknowns);
    print_horizons(out, result.horizons);
    out.flush();
    result.complete = shots.empty() || run_models(shots, models, progress, out, result.recorded);
    files.write([&](std::ostream& json) { write_json(json, result); },
                [&](std::ostream& csv) { write_csv(csv, result); });
    if (files.fault()) return fail(error, *files.fault());
    return result.complete ? Status::kGood : say_interrupted(error, options.out);
}

Status validate(const ValidateOptions& options, std::ostream& out, std::ostream& error) {
    return validate(options, recorded_models(options.threads), out, error);
}

}  // namespace poolhall::lab
