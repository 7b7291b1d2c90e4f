#pragma once

#include "client/lab/accuracy/results.hpp"

#include <ostream>

namespace poolhall::lab {

/// What an ensemble showed, a line a solver and rate, and the orders of convergence below.
void print_table(std::ostream& out, const EnsembleResult& result);

/// A line a speed, a column a solver.
void print_table(std::ostream& out, const std::vector<Tunnelling>& all);

/// A line a number of balls, a column a solver.
void print_table(std::ostream& out, const std::vector<CrowdCosts>& all);

}  // namespace poolhall::lab
