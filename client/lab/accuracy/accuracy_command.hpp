#pragma once

#include "client/lab/accuracy/ensemble_run.hpp"
#include "client/lab/run/status.hpp"

#include <ostream>
#include <string>
#include <vector>

namespace poolhall::lab {

struct AccuracyOptions {
    RunPlan plan;
    std::string out;                ///< folder; empty: only the tables are printed
    std::vector<std::string> only;  ///< parts_of_accuracy() to run; none: all
    bool bar = false;               ///< show how far it is, on `error`
};

/// The names of what can be run: the ensembles, "tunnelling", "crowds".
[[nodiscard]] std::vector<std::string> parts_of_accuracy();

/// Measures, and prints a table of each part as soon as it is finished. Ctrl-C keeps what is
/// finished, says so on `error` and gives kInterrupted. What cannot be written is said in one line
/// before the run begins.
[[nodiscard]] Status measure_accuracy(const AccuracyOptions& options, std::ostream& out,
                                      std::ostream& error);

}  // namespace poolhall::lab
