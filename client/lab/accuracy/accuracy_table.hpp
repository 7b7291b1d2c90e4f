#pragma once

#include "client/lab/accuracy/results.hpp"

#include <ostream>

namespace poolhall::lab {

/// What an ensemble showed, a line a solver and rate, and the orders of convergence below. CPU time
/// of a shot and of its worst 1/30 s; rest error: median, 90 % and maximum; median error of the
/// first impact's time; share of events that are the same, and the median time of the first that is
/// not; shares of shots with another verdict and another winner; impacts a shot missed and
/// invented. All else is in the files.
void print_table(std::ostream& out, const EnsembleResult& result);

/// A line a speed, a column a solver.
void print_table(std::ostream& out, const std::vector<Tunnelling>& all);

/// A line a number of balls, a column a solver.
void print_table(std::ostream& out, const std::vector<CrowdCosts>& all);

}  // namespace poolhall::lab
