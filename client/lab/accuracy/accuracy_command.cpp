#include "client/lab/accuracy/accuracy_command.hpp"

#include "client/lab/accuracy/accuracy_table.hpp"
#include "client/lab/accuracy/side_runs.hpp"
#include "client/lab/output/result_files.hpp"
#include "client/lab/run/long_run.hpp"
#include "client/lab/run/progress.hpp"

#include <algorithm>
#include <chrono>

namespace poolhall::lab {

namespace {

constexpr const char* kTunnelling = "tunnelling";
constexpr const char* kCrowds = "crowds";

/// The command line that gives the same again.
std::string command_of(const AccuracyOptions& options) {
    std::string line = command_line("accuracy", options.plan);
    for (const std::string& part : options.only)
        line += " --only " + part;
    return line;
}

/// Runs part after part until all are done or it is interrupted.
class AccuracyRun {
  public:
    AccuracyRun(const AccuracyOptions& options, std::ostream& out, std::ostream& error)
        : options_(options), out_(out), progress_(error, options.bar) {}

    AccuracyResult run() {
        const auto start = std::chrono::steady_clock::now();
        result_.command = command_of(options_);
        result_.seed = options_.plan.seed;
        result_.quick = options_.plan.quick;
        result_.build = build_info();
        print_head(out_, result_.command, result_.build);
        result_.complete = run_parts();
        progress_.clear();
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
        result_.seconds = passed.count();
        return std::move(result_);
    }

  private:
    [[nodiscard]] bool is_wanted(std::string_view part) const {
        return options_.only.empty() ||
               std::find(options_.only.begin(), options_.only.end(), part) != options_.only.end();
    }

    /// False if it was interrupted.
    bool run_parts() {
        for (const Ensemble& ensemble : ensembles()) {
            if (!is_wanted(ensemble.name)) continue;
            auto found = run_ensemble(ensemble, options_.plan, progress_);
            if (!found) return false;
            show(*found);
            result_.ensembles.push_back(std::move(*found));
        }
        return run_part(kTunnelling, run_tunnelling, result_.tunnelling) &&
               run_part(kCrowds, run_crowds, result_.crowds);
    }

    template <class Run, class Found>
    bool run_part(const char* name, Run find, Found& result) {
        if (!is_wanted(name)) return true;
        auto found = find(options_.plan, progress_);
        if (!found) return false;
        show(*found);
        result = std::move(*found);
        return true;
    }

    template <class Found>
    void show(const Found& found) {
        progress_.clear();
        print_table(out_, found);
    }

    const AccuracyOptions& options_;
    std::ostream& out_;
    Progress progress_;
    AccuracyResult result_;
};

}  // namespace

std::vector<std::string> parts_of_accuracy() {
    std::vector<std::string> parts;
    for (const Ensemble& ensemble : ensembles())
        parts.emplace_back(ensemble.name);
    parts.insert(parts.end(), {kTunnelling, kCrowds});
    return parts;
}

Status measure_accuracy(const AccuracyOptions& options, std::ostream& out, std::ostream& error) {
    ResultFiles files(options.out, "accuracy");
    if (files.fault()) return fail(error, *files.fault());
    const Interruption interruption;
    const AccuracyResult result = AccuracyRun(options, out, error).run();
    files.write([&](std::ostream& json) { write_json(json, result); },
                [&](std::ostream& csv) { write_csv(csv, result); });
    if (files.fault()) return fail(error, *files.fault());
    return result.complete ? Status::kGood : say_interrupted(error, options.out);
}

}  // namespace poolhall::lab
