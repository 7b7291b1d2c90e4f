#include "server/base/shot_costs.hpp"

#include "shared/physics/simulate.hpp"

#include <algorithm>
#include <cassert>

namespace poolhall::server {

namespace {

std::size_t cell_of(SolverKind solver, std::string_view kernel) {
    const auto kernels = kernel_names();
    const auto found = std::find(kernels.begin(), kernels.end(), kernel);
    assert(found != kernels.end());
    return static_cast<std::size_t>(solver) * kernels.size() +
           static_cast<std::size_t>(found - kernels.begin());
}

}  // namespace

ShotCosts::ShotCosts() : cells_(kCount<SolverKind> * kernel_names().size()) {}

void ShotCosts::add(SolverKind solver, std::string_view kernel, std::chrono::nanoseconds cpu) {
    Cell& cell = cells_[cell_of(solver, kernel)];
    cell.shots.fetch_add(1, std::memory_order_relaxed);
    cell.cpu_ns.fetch_add(cpu.count(), std::memory_order_relaxed);
}

std::vector<ShotCosts::Sum> ShotCosts::sums() const {
    const auto kernels = kernel_names();
    std::vector<Sum> sums;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        const std::uint64_t shots = cells_[i].shots.load(std::memory_order_relaxed);
        if (shots == 0) continue;
        sums.push_back(
            {static_cast<SolverKind>(i / kernels.size()), kernels[i % kernels.size()], shots,
             std::chrono::nanoseconds(cells_[i].cpu_ns.load(std::memory_order_relaxed))});
    }
    return sums;
}

}  // namespace poolhall::server
