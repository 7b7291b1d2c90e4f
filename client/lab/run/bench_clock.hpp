#pragma once

#include "client/compare/cpu_time.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace poolhall::lab {

using compare::cpu_time_ns;

/// Counts the instructions of this thread where processor and kernel let it (perf_event_open);
/// many virtual machines do not.
class InstructionCounter {
  public:
    InstructionCounter();
    ~InstructionCounter();
    InstructionCounter(const InstructionCounter&) = delete;
    InstructionCounter& operator=(const InstructionCounter&) = delete;

    /// So far; nothing where they cannot be counted.
    [[nodiscard]] std::optional<std::uint64_t> count() const;

  private:
    int file_ = -1;
};

struct Cost {
    double ns = 0;  ///< CPU time, the median of the repeats
    std::optional<double> instructions;
};

/// How often something is timed.
struct Repeats {
    std::size_t count = 7;
    double least_ns = 2e7;  ///< of one of them: long against the clock's steps
};

/// What one call of work() costs, once it is warm.
template <class Work>
[[nodiscard]] Cost measure(Work work, const Repeats& repeats = {}) {
    work();
    const double start = cpu_time_ns();
    work();
    const double once = std::max(cpu_time_ns() - start, 1.0);
    const auto rounds = static_cast<std::uint64_t>(std::max(repeats.least_ns / once, 1.0));
    const InstructionCounter counter;
    const auto before = counter.count();
    std::vector<double> times(repeats.count);
    for (double& time : times) {
        const double begin = cpu_time_ns();
        for (std::uint64_t i = 0; i < rounds; ++i)
            work();
        time = (cpu_time_ns() - begin) / static_cast<double>(rounds);
    }
    Cost cost;
    if (const auto after = counter.count(); before && after)
        cost.instructions =
            static_cast<double>(*after - *before) / static_cast<double>(rounds * repeats.count);
    const auto middle = times.begin() + std::ssize(times) / 2;
    std::nth_element(times.begin(), middle, times.end());
    cost.ns = *middle;
    return cost;
}

}  // namespace poolhall::lab
