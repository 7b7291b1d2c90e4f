#pragma once

#include "shared/physics/effects/kernels.hpp"
#include "shared/physics/solvers/shot_run.hpp"

#include <cstddef>
#include <tuple>
#include <utility>

namespace poolhall {

/// Makes the kernel at that place in KernelList from the run's scene and calls solve(kernel).
template <class Solve>
void with_kernel(std::size_t index, const ShotRun& run, Solve solve) {
    [&]<std::size_t... kIndex>(std::index_sequence<kIndex...>) {
        [[maybe_unused]] const bool found =
            ((kIndex == index &&
              (solve(std::tuple_element_t<kIndex, KernelList>(run.scene())), true)) ||
             ...);
    }
    (std::make_index_sequence<std::tuple_size_v<KernelList>>{});
}

}  // namespace poolhall
