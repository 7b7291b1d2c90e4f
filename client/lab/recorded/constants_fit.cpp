#include "client/lab/recorded/constants_fit.hpp"

#include "client/lab/recorded/minimise.hpp"
#include "client/lab/recorded/parallel.hpp"
#include "client/lab/statistics/quantiles.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>

namespace poolhall::lab {

namespace {

using Candidates = std::vector<ShotParameters>;

Quartiles quartiles_of(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return {quantile(values, 0.25), quantile(values, 0.5), quantile(values, 0.75)};
}

/// Fits of all shots under one set of constants.
struct TableFit {
    std::vector<Candidates> candidates;  ///< by shot, best first
    std::vector<ShotFit::Distances> distances;

    explicit TableFit(std::size_t shots) : candidates(shots), distances(shots) {}

    /// What a good set of constants makes small.
    [[nodiscard]] double score() const {
        constexpr double kLost = 1;        // m; farther off says no more
        constexpr double kAsGood = 0.005;  // m; what the recording's own errors hide
        double sum = 0;
        for (const ShotFit::Distances& one : distances)
            sum += std::log(std::min(one.whole, kLost) + 2 * kAsGood) +
                   std::log(std::min(one.to_third_rail, kLost) + kAsGood);
        return sum / static_cast<double>(distances.size());
    }
};

/// fit(shot's fit, its place): its candidates.
template <class Fit>
TableFit fit_all(const std::vector<RecordedShot>& shots, const TableConstants& constants,
                 std::size_t threads, Fit fit) {
    TableFit found(shots.size());
    in_parallel(shots.size(), threads, [&](std::size_t i) {
        ShotFit one(shots[i], constants);
        found.candidates[i] = fit(one, i);
        found.distances[i] = one.distances(found.candidates[i].front());
    });
    return found;
}

TableFit fit_from_scratch(const std::vector<RecordedShot>& shots, const TableConstants& constants,
                          const FitPlan& plan, std::size_t threads, Progress& progress) {
    std::mutex mutex;
    return fit_all(shots, constants, threads, [&](ShotFit& one, std::size_t i) {
        Candidates found = one.from_scratch(plan, i + 1);
        const std::lock_guard lock(mutex);
        progress.step();
        return found;
    });
}

/// The search for constants, shots being refitted from where they fitted last.
class ConstantsSearch {
  public:
    ConstantsSearch(const std::vector<RecordedShot>& shots, const TableConstants& start,
                    const TableFitPlan& plan, Progress& progress)
        : shots_(shots),
          plan_(plan),
          progress_(progress),
          fitted_(fitted_constants(start.rail)),
          best_(start),
          near_(shots.size()) {}

    std::optional<TableConstants> run() {
        for (int round = 0; round < plan_.rounds; ++round) {
            progress_.begin("shots", shots_.size());
            near_ = fit_from_scratch(shots_, best_, plan_.first, plan_.threads, progress_);
            if (Interruption::asked_for()) return std::nullopt;
            score_ = near_.score();
            progress_.begin("constants", static_cast<std::size_t>(plan_.evaluations));
            search();
            if (Interruption::asked_for()) return std::nullopt;
        }
        return best_;
    }

  private:
    void search() {
        SearchSpace space;
        for (const FittedConstant& constant : fitted_) {
            space.start.push_back(*constant.place(best_));
            space.low.push_back(constant.low);
            space.high.push_back(constant.high);
            space.step.push_back(constant.step);
        }
        (void)minimise(SearchMethod::kSimplex, space, plan_.evaluations,
                       [&](const double* values) { return try_out(values); });
    }

    double try_out(const double* values) {
        if (Interruption::asked_for()) return score_;
        TableConstants constants = best_;
        for (std::size_t i = 0; i < fitted_.size(); ++i)
            *fitted_[i].place(constants) = values[i];
        TableFit found = fit_all(
            shots_, constants, plan_.threads,
            [&](ShotFit& one, std::size_t i) { return one.from_near(near_.candidates[i]); });
        progress_.step();
        if (Interruption::asked_for()) return score_;
        const double score = found.score();
        if (score < score_) {
            score_ = score;
            best_ = constants;
            near_ = std::move(found);
        }
        return score;
    }

    const std::vector<RecordedShot>& shots_;
    const TableFitPlan& plan_;
    Progress& progress_;
    std::vector<FittedConstant> fitted_;
    TableConstants best_;
    TableFit near_;
    double score_ = 0;
};

}  // namespace

std::optional<ShotsFound> fit_shots(const std::vector<RecordedShot>& shots,
                                    const TableConstants& constants, const FitPlan& plan,
                                    std::size_t threads, Progress& progress) {
    progress.begin("shots", shots.size());
    const TableFit found = fit_from_scratch(shots, constants, plan, threads, progress);
    if (Interruption::asked_for()) return std::nullopt;
    std::vector<double> whole;
    std::vector<double> third;
    for (const ShotFit::Distances& one : found.distances) {
        whole.push_back(one.whole);
        third.push_back(one.to_third_rail);
    }
    return ShotsFound{shots.size(), quartiles_of(whole), quartiles_of(third)};
}

std::optional<TableConstants> fit_constants(const std::vector<RecordedShot>& shots,
                                            const TableConstants& start, const TableFitPlan& plan,
                                            Progress& progress) {
    return ConstantsSearch(shots, start, plan, progress).run();
}

}  // namespace poolhall::lab
