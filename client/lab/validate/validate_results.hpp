#pragma once

#include "client/lab/output/build_info.hpp"
#include "client/lab/recorded/recorded_run.hpp"
#include "client/lab/validate/curves.hpp"
#include "client/lab/validate/measured_table.hpp"
#include "client/lab/validate/unknown.hpp"

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace poolhall::lab {

/// What `poolhall-lab validate` finds.
struct ValidateResult {
    std::string command;
    bool complete = false;  ///< false: interrupted, and only what was finished is here
    BuildInfo build;
    std::vector<MeasuredTable> tables;
    std::vector<Figure> figures;
    std::vector<Unknown> unknowns;
    std::vector<HorizonByError> horizons;
    std::size_t recorded_shots = 0;  ///< in the recording; 0 without one
    std::vector<RecordedResult> recorded;
};

/// "poolhall.validate/1" (README.md).
void write_json(std::ostream& out, const ValidateResult& result);
/// A line a published value and model; their rms in a line each; then the recorded shots.
void write_csv(std::ostream& out, const ValidateResult& result);

void print_table(std::ostream& out, const MeasuredTable& table);
void print_unknowns(std::ostream& out, const std::vector<Unknown>& unknowns);
void print_horizons(std::ostream& out, const std::vector<HorizonByError>& horizons);
void print_recorded(std::ostream& out, const RecordedResult& result);

}  // namespace poolhall::lab
