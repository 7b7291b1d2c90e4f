#include "shared/physics/solvers/exact_arc.hpp"

#include "shared/physics/solvers/refusals.hpp"
#include "shared/physics/solvers/solver.hpp"
#include "shared/physics/solvers/with_kernel.hpp"

namespace poolhall {

extern const Solver kExactArcSolver;

const Solver kExactArcSolver{.kind = SolverKind::kExactArc,
                             .has_ticks = true,
                             .refusal = refusal_by_closed_form,
                             .run = [](std::size_t kernel, ShotRun& shot, SolverMemory& memory) {
                                 auto& own = memory.as<ExactArcMemory>();
                                 with_kernel(kernel, shot,
                                             [&]<class Kernel>(const Kernel& effects) {
                                                 ExactArcSolver<Kernel>(effects, shot, own).solve();
                                             });
                             }};

}  // namespace poolhall
