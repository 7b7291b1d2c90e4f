#include "shared/physics/simulate.hpp"

#include "shared/physics/effects/effect_set.hpp"
#include "shared/physics/shot_run.hpp"
#include "shared/physics/solvers/euler.hpp"
#include "shared/physics/solvers/overlap.hpp"

#include <array>
#include <cassert>
#include <tuple>
#include <type_traits>

namespace poolhall {

namespace {

template <class Kernel>
void run_kernel(const Scene& scene, double sample_hz, ShotTrace& trace) {
    trace.kernel = Kernel::kName;
    trace.solver = scene.solver.kind;
    const Kernel kernel(scene);
    ShotRun run(scene, sample_hz, trace);
    switch (scene.solver.kind) {
        case SolverKind::kEuler:
            EulerSolver<Kernel>(kernel, run).solve();
            break;
        case SolverKind::kOverlap:
            OverlapSolver<Kernel>(kernel, run).solve();
            break;
    }
}

/// Runs the first kernel of the list that covers the scene and that `wanted` accepts by name.
template <class Wanted, class... Kernel>
bool run_first(const Scene& scene, double sample_hz, ShotTrace& trace, Wanted wanted,
               std::type_identity<std::tuple<Kernel...>>) {
    return ((Kernel::covers(scene) && wanted(Kernel::kName) &&
             (run_kernel<Kernel>(scene, sample_hz, trace), true)) ||
            ...);
}

template <class... Kernel>
constexpr std::array<std::string_view, sizeof...(Kernel)> names_of(
    std::type_identity<std::tuple<Kernel...>>) {
    return {Kernel::kName...};
}

}  // namespace

void simulate(const Scene& scene, double sample_hz, ShotTrace& trace) {
    [[maybe_unused]] const bool covered = run_first(
        scene, sample_hz, trace, [](std::string_view) { return true; },
        std::type_identity<KernelList>{});
    assert(covered);
}

ShotTrace simulate(const Scene& scene, double sample_hz) {
    ShotTrace trace;
    simulate(scene, sample_hz, trace);
    return trace;
}

std::span<const std::string_view> kernel_names() {
    static constexpr auto kNames = names_of(std::type_identity<KernelList>{});
    return kNames;
}

bool simulate_by(std::string_view kernel, const Scene& scene, double sample_hz, ShotTrace& trace) {
    return run_first(
        scene, sample_hz, trace, [&](std::string_view name) { return name == kernel; },
        std::type_identity<KernelList>{});
}

}  // namespace poolhall
