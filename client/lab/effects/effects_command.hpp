#pragma once

#include "client/lab/run/run_plan.hpp"
#include "client/lab/run/status.hpp"

#include <ostream>
#include <string>

namespace poolhall::lab {

struct EffectsOptions {
    RunPlan plan;      ///< 200 shots of each kernel and effect, or 20 if quick
    std::string out;   ///< folder; empty: only the tables are printed
    bool bar = false;  ///< show how far it is, on `error`
    /// The poolhall-lab whose instructions callgrind counts; empty: the processor counts, if it
    /// can.
    std::string counted = {};
};

/// Measures what every kernel and every effect costs, and how far each effect moves the outcome;
/// checks first that shots without an effect and with it at zero strength are the same. Ctrl-C
/// keeps what is finished. What cannot be written, or counted, is said in one line before the run.
[[nodiscard]] Status measure_effects(const EffectsOptions& options, std::ostream& out,
                                     std::ostream& error);

}  // namespace poolhall::lab
