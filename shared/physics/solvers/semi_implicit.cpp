#include "shared/physics/solvers/refusals.hpp"
#include "shared/physics/solvers/solver.hpp"
#include "shared/physics/solvers/stepping.hpp"
#include "shared/physics/solvers/with_kernel.hpp"

namespace poolhall {

extern const Solver kSemiImplicitSolver;

const Solver kSemiImplicitSolver{
    .kind = SolverKind::kSemiImplicit,
    .has_ticks = true,
    .refusal = refusal_by_euler_steps,
    .run = [](std::size_t kernel, ShotRun& shot, SolverMemory& memory) {
        auto& own = memory.as<SteppingMemory>();
        with_kernel(kernel, shot, [&]<class Kernel>(const Kernel& effects) {
            SteppingSolver<Kernel, Scheme::kSemiImplicit>(effects, shot, own).solve();
        });
    }};

}  // namespace poolhall
