#include "shared/physics/solvers/overlap.hpp"

#include "shared/physics/solvers/refusals.hpp"
#include "shared/physics/solvers/solver.hpp"
#include "shared/physics/solvers/with_kernel.hpp"

namespace poolhall {

namespace {

std::optional<SceneError> refusal(const Scene& scene) {
    if (auto error = refusal_by_euler_steps(scene)) return error;
    if (scene.table.pockets == PocketModel::kPool)
        return SceneError{"/solver/kind", "overlap knows no mouths: not on a pool table"};
    if (scene.effects.airborne)
        return SceneError{"/solver/kind", "overlap knows no heights: not with airborne"};
    return std::nullopt;
}

}  // namespace

extern const Solver kOverlapSolver;

const Solver kOverlapSolver{.kind = SolverKind::kOverlap,
                            .has_ticks = true,
                            .refusal = refusal,
                            .run = [](std::size_t kernel, ShotRun& shot, SolverMemory& /*memory*/) {
                                with_kernel(kernel, shot, [&]<class Kernel>(const Kernel& effects) {
                                    OverlapSolver<Kernel>(effects, shot).solve();
                                });
                            }};

}  // namespace poolhall
