#include "shared/physics/solvers/event.hpp"

#include "shared/physics/solvers/solvers.hpp"
#include "shared/physics/solvers/with_kernel.hpp"

namespace poolhall {

void run_event(std::size_t kernel, ShotRun& run) {
    with_kernel(kernel, run, [&]<class Kernel>(const Kernel& effects) {
        EventSolver<Kernel>(effects, run).solve();
    });
}

}  // namespace poolhall
