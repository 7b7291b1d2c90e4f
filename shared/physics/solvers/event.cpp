#include "shared/physics/solvers/event.hpp"

#include "shared/physics/solvers/refusals.hpp"
#include "shared/physics/solvers/solver.hpp"
#include "shared/physics/solvers/with_kernel.hpp"

namespace poolhall {

extern const Solver kEventSolver;

const Solver kEventSolver{.kind = SolverKind::kEvent,
                          .has_ticks = false,
                          .refusal = refusal_by_closed_form,
                          .run = [](std::size_t kernel, ShotRun& shot, SolverMemory& memory) {
                              auto& own = memory.as<EventMemory>();
                              with_kernel(kernel, shot, [&]<class Kernel>(const Kernel& effects) {
                                  EventSolver<Kernel>(effects, shot, own).solve();
                              });
                          }};

}  // namespace poolhall
