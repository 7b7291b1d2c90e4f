#pragma once

#include "shared/physics/scene/trace.hpp"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <string_view>
#include <vector>

namespace poolhall::server {

/// What the simulation of shots has cost so far, by solver and kernel. Written and read from any
/// thread.
class ShotCosts {
  public:
    ShotCosts();

    /// Counts a shot of that solver and kernel (one of kernel_names()).
    void add(SolverKind solver, std::string_view kernel, std::chrono::nanoseconds cpu);

    struct Sum {
        SolverKind solver;
        std::string_view kernel;
        std::uint64_t shots;
        std::chrono::nanoseconds cpu;
    };

    /// Of each pair that has had a shot.
    [[nodiscard]] std::vector<Sum> sums() const;

  private:
    struct Cell {
        std::atomic<std::uint64_t> shots{0};
        std::atomic<std::int64_t> cpu_ns{0};
    };

    std::vector<Cell> cells_;  ///< a row of all kernels for each solver
};

}  // namespace poolhall::server
