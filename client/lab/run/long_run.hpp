#pragma once

#include "client/lab/output/build_info.hpp"
#include "client/lab/run/status.hpp"

#include <ostream>
#include <string>

// What the commands that run for long say.
namespace poolhall::lab {

/// The command and what it was measured with.
void print_head(std::ostream& out, const std::string& command, const BuildInfo& build);

/// `folder` has the results; empty: they were only printed.
[[nodiscard]] Status say_interrupted(std::ostream& error, const std::string& folder);

}  // namespace poolhall::lab
