#pragma once

#include "shared/physics/motion/arc.hpp"
#include "shared/physics/solvers/stepping_memory.hpp"

#include <vector>

namespace poolhall {

/// A stretch of a ball's way that is taken as straight and uniform.
struct Chord {
    Vec3 v;         ///< m/s
    Real from = 0;  ///< s
    Real to = 0;    ///< s
};

/// The memory of the solver exact_arc.
struct ExactArcMemory {
    SteppingMemory stepping;
    // Of each ball.
    std::vector<Arc> arcs;
    std::vector<MovingBall> launched;  ///< as it was at its arc's beginning
    std::vector<Chord> chords;
    std::vector<Real> ends;  ///< of each contact; when chords begin anew, s
};

}  // namespace poolhall
