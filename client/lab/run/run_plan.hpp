#pragma once

#include "client/lab/run/bench_clock.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

namespace poolhall::lab {

/// How thorough a long run is.
struct RunPlan {
    std::uint64_t seed = 1;
    bool quick = false;
    std::size_t shots = 0;  ///< of each part of the run; 0: as many as suit it

    [[nodiscard]] Repeats repeats() const { return quick ? Repeats{3, 2e6} : Repeats{7, 2e7}; }
};

/// The command line of `command` that gives the same again: "poolhall-lab effects --seed 1".
[[nodiscard]] std::string command_line(const std::string& command, const RunPlan& plan);

}  // namespace poolhall::lab
