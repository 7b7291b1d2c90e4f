#include "shared/physics/solvers/overlap.hpp"

#include "shared/physics/solvers/solvers.hpp"
#include "shared/physics/solvers/with_kernel.hpp"

namespace poolhall {

void run_overlap(std::size_t kernel, ShotRun& run) {
    with_kernel(kernel, run, [&]<class Kernel>(const Kernel& effects) {
        OverlapSolver<Kernel>(effects, run).solve();
    });
}

}  // namespace poolhall
