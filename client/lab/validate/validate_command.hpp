#pragma once

#include "client/lab/recorded/recorded_run.hpp"
#include "client/lab/run/status.hpp"

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace poolhall::lab {

struct ValidateOptions {
    std::string out = {};       ///< folder; empty: the tables are only printed
    std::string recorded = {};  ///< file of recorded shots; empty: none
    std::size_t threads = 1;    ///< that fit recorded shots; the results are the same for any
    bool bar = false;           ///< show how far it is, on `error`
};

/// Holds every model that applies against every published measurement, and prints a table each;
/// with recorded shots, also how far their fits are from them, by model of the rail. Ctrl-C keeps
/// what is finished. A file that is no recording is said in one line before all else.
[[nodiscard]] Status validate(const ValidateOptions& options, std::ostream& out,
                              std::ostream& error);

/// The same with other models for the recorded shots, or less thorough ones.
[[nodiscard]] Status validate(const ValidateOptions& options,
                              const std::vector<RecordedModel>& models, std::ostream& out,
                              std::ostream& error);

}  // namespace poolhall::lab
