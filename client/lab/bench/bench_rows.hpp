#pragma once

#include <optional>
#include <string>
#include <vector>

namespace poolhall::lab {

/// What another program reaches, in a row's unit.
struct Reference {
    std::string program;
    double value = 0;
};

struct BenchRow {
    std::string name;
    double value = 0;
    std::string unit;
    std::string check;  ///< what was right before it was timed; what was wrong, if `wrong`
    bool wrong = false;
    std::optional<double> instructions = {};  ///< for one of what the unit counts
    std::vector<Reference> references = {};
};

/// One group of rows, made when it is asked for: each takes a second or a few.
struct BenchGroup {
    std::string name;
    std::vector<BenchRow> (*run)();
};

[[nodiscard]] const std::vector<BenchGroup>& bench_groups();

}  // namespace poolhall::lab
