#pragma once

#include "client/lab/recorded/constants_fit.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace poolhall::lab {

/// A model of the rail, held against the recording.
struct RecordedModel {
    std::string name;  ///< "Han"
    TableConstants start;
    TableFitPlan plan;
};

/// What the recording says of a model. Shots are counted from 1.
struct RecordedResult {
    std::string model;
    std::vector<std::pair<std::string, double>> constants;  ///< as fitted, SI
    ShotsFound unfitted;  ///< even shots under the constants that the fit began with
    ShotsFound odd;       ///< the shots that the constants were fitted to
    ShotsFound even;      ///< those that they were not
    double seconds = 0;   ///< that it took
};

[[nodiscard]] std::vector<RecordedModel> recorded_models(std::size_t threads);

/// Nothing if it was interrupted.
[[nodiscard]] std::optional<RecordedResult> run_recorded(const std::vector<RecordedShot>& shots,
                                                         const RecordedModel& model,
                                                         Progress& progress);

}  // namespace poolhall::lab
