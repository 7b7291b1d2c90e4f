#pragma once

#include "client/lab/run/status.hpp"
#include "shared/physics/scene/scene.hpp"

#include <ostream>
#include <string>
#include <vector>

namespace poolhall::lab {

struct CompareOptions {
    std::string file = "-";           ///< one scene; "-" is standard input
    std::vector<SolverSpec> solvers;  ///< none: event, euler:30, euler:120, overlap:30
    std::string out;                  ///< folder of compare.svg and compare.png; empty for none
    std::string picture;              ///< a file that ends in .svg or .png; empty for none
};

/// Simulates the scene by each solver and prints their events side by side, where they part, how
/// far apart the balls come to rest, and what it costs; draws all paths on one table if asked to.
/// What is wrong goes to `error` in one line, before anything is simulated.
[[nodiscard]] Status compare_solvers(const CompareOptions& options, std::ostream& out,
                                     std::ostream& error);

}  // namespace poolhall::lab
