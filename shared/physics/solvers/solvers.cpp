#include "shared/physics/solvers/solvers.hpp"

#include <array>

namespace poolhall {

// Each in a file of its own.
extern const Solver kEulerSolver;
extern const Solver kOverlapSolver;
extern const Solver kSemiImplicitSolver;
extern const Solver kExactArcSolver;
extern const Solver kEventSolver;

namespace {

/// Every solver, in the order of SolverKind.
constexpr std::array kSolvers{&kEulerSolver, &kOverlapSolver, &kSemiImplicitSolver,
                              &kExactArcSolver, &kEventSolver};
static_assert(kSolvers.size() == kCount<SolverKind>, "a kind has no solver");

}  // namespace

const Solver& solver_of(SolverKind kind) {
    return *kSolvers[static_cast<std::size_t>(kind)];
}

}  // namespace poolhall
