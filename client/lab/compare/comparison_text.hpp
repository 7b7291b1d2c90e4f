#pragma once

#include "client/compare/comparison.hpp"

#include <ostream>

// What several solvers make of one scene, in words and numbers. The scene must be that of the
// comparison, which must have a reference.
namespace poolhall::lab {

/// A column a solver: each event with its time, the first that the reference has otherwise marked
/// by a star.
void print_events(std::ostream& out, const Scene& scene, const compare::Comparison& comparison);

/// Where each solver's story parts from the reference's.
void print_differences(std::ostream& out, const Scene& scene,
                       const compare::Comparison& comparison);

/// How far from the reference's place each ball comes to rest.
void print_rest_distances(std::ostream& out, const Scene& scene,
                          const compare::Comparison& comparison);

void print_costs(std::ostream& out, const compare::Comparison& comparison);

}  // namespace poolhall::lab
