#pragma once

#include "client/lab/run/status.hpp"
#include "protocol/codec/result_json.hpp"
#include "shared/physics/scene/scene.hpp"

#include <istream>
#include <optional>
#include <ostream>
#include <string>

namespace poolhall::lab {

struct SimulateOptions {
    std::optional<SolverSpec> solver;  ///< instead of the scenes' own
    protocol::Numbers numbers = protocol::Numbers::kDecimal;
    double sample_hz = 0;  ///< 0: no samples
};

/// Simulates the scenes of `in`, JSON Lines or one object, and writes a result a line, each flushed
/// before the next scene is taken. What is wrong with a line goes to `error` in one line,
/// "line 3: /balls/1/r: overlaps /balls/0", and the other lines are still done.
[[nodiscard]] Status simulate_all(const SimulateOptions& options, std::istream& in,
                                  std::ostream& out, std::ostream& error);

/// The same with a file, or standard input for "-".
[[nodiscard]] Status simulate_file(const SimulateOptions& options, const std::string& file,
                                   std::ostream& out, std::ostream& error);

}  // namespace poolhall::lab
