#include "shared/physics/solvers/exact_arc.hpp"

#include "shared/physics/solvers/solvers.hpp"
#include "shared/physics/solvers/with_kernel.hpp"

namespace poolhall {

void run_exact_arc(std::size_t kernel, ShotRun& run) {
    with_kernel(kernel, run, [&]<class Kernel>(const Kernel& effects) {
        ExactArcSolver<Kernel>(effects, run).solve();
    });
}

}  // namespace poolhall
