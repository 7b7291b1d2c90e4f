#pragma once

#include "client/lab/recorded/shot_fit.hpp"
#include "client/lab/run/progress.hpp"

#include <optional>
#include <string>
#include <vector>

namespace poolhall::lab {

/// How thorough the fit of a table is.
struct TableFitPlan {
    std::size_t threads = 1;
    FitPlan first = {200, 24, 3};  ///< of each shot, before the constants move
    FitPlan last = {800, 64, 6};   ///< of each shot, when they stand
    int evaluations = 160;         ///< of constants, in each of the rounds
    int rounds = 2;
};

/// The spread of a distance over shots, m.
struct Quartiles {
    double p25 = 0;
    double median = 0;
    double p75 = 0;
};

/// Over some shots, each fitted on its own under the same constants.
struct ShotsFound {
    std::size_t shots = 0;
    Quartiles whole;          ///< all balls, the whole shot
    Quartiles to_third_rail;  ///< the cue ball, up to its third rail
};

/// Fits every shot under those constants. Nothing if it was interrupted.
[[nodiscard]] std::optional<ShotsFound> fit_shots(const std::vector<RecordedShot>& shots,
                                                  const TableConstants& constants,
                                                  const FitPlan& plan, std::size_t threads,
                                                  Progress& progress);

/// The constants under which the shots fit best: those that make least the mean of the logarithms
/// of both distances, which no single shot that went another way can rule. Nothing if it was
/// interrupted.
[[nodiscard]] std::optional<TableConstants> fit_constants(const std::vector<RecordedShot>& shots,
                                                          const TableConstants& start,
                                                          const TableFitPlan& plan,
                                                          Progress& progress);

}  // namespace poolhall::lab
