#pragma once

#include "shared/physics/effects/kernels.hpp"
#include "shared/physics/solvers/shot_run.hpp"

#include <cstddef>
#include <tuple>
#include <utility>

namespace poolhall {

/// A scene as effects are made from it (SceneLike), with what a simulator keeps of its table.
struct KernelScene {
    KernelScene(const Scene& scene, KeptCushionMap& kept)
        : table(scene.table),
          ball(scene.ball),
          gravity(scene.gravity),
          effects(scene.effects),
          cushions(kept) {}

    const Table& table;
    const BallSpec& ball;
    Real gravity;  ///< m/s^2
    const Effects& effects;
    KeptCushionMap& cushions;
};

/// Makes the kernel at that place in KernelList from the run's scene and calls solve(kernel).
template <class Solve>
void with_kernel(std::size_t index, const ShotRun& run, Solve solve) {
    const KernelScene scene(run.scene(), run.workspace().cushions);
    [&]<std::size_t... kIndex>(std::index_sequence<kIndex...>) {
        [[maybe_unused]] const bool found =
            ((kIndex == index && (solve(std::tuple_element_t<kIndex, KernelList>(scene)), true)) ||
             ...);
    }
    (std::make_index_sequence<std::tuple_size_v<KernelList>>{});
}

}  // namespace poolhall
