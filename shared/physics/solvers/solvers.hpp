#pragma once

#include "shared/physics/solvers/solver.hpp"

namespace poolhall {

[[nodiscard]] const Solver& solver_of(SolverKind kind);

}  // namespace poolhall
