#include "shared/physics/simulate.hpp"

#include "shared/physics/effects/effect_set.hpp"
#include "shared/physics/shot_run.hpp"
#include "shared/physics/solvers/euler.hpp"
#include "shared/physics/solvers/overlap.hpp"

#include <cassert>
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

/// Runs the first kernel of the list that covers the scene.
template <class... Kernel>
bool run_first(const Scene& scene, double sample_hz, ShotTrace& trace,
               std::type_identity<std::tuple<Kernel...>>) {
    return ((Kernel::covers(scene) && (run_kernel<Kernel>(scene, sample_hz, trace), true)) || ...);
}

}  // namespace

void simulate(const Scene& scene, double sample_hz, ShotTrace& trace) {
    [[maybe_unused]] const bool covered =
        run_first(scene, sample_hz, trace, std::type_identity<KernelList>{});
    assert(covered);
}

ShotTrace simulate(const Scene& scene, double sample_hz) {
    ShotTrace trace;
    simulate(scene, sample_hz, trace);
    return trace;
}

}  // namespace poolhall
