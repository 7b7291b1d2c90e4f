#pragma once

#include "client/lab/run/status.hpp"

#include <ostream>
#include <string>

namespace poolhall::lab {

/// Measures, and prints a table. Each answer is checked before it is timed; a wrong one is said and
/// makes the status kWrong. `csv_file`: the same as CSV with compiler, flags and processor; empty
/// for none.
[[nodiscard]] Status bench(const std::string& csv_file, std::ostream& out, std::ostream& error);

/// Prints a line a corpus: name and hash.
[[nodiscard]] Status print_hashes(std::ostream& out);

}  // namespace poolhall::lab
