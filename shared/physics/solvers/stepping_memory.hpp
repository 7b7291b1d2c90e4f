#pragma once

#include "shared/physics/search/free_boxes.hpp"

#include <cstddef>
#include <vector>

namespace poolhall {

/// A stretch of a ball's way that is taken as straight and uniform.
struct Chord {
    Vec3 v;         ///< m/s
    Real from = 0;  ///< s
    Real to = 0;    ///< s
};

/// How a ball's box is made.
struct Outlook {
    Vec2 clear;            ///< up to which |x| and |y| its centre meets nothing of the table, m
    Real ticks = 1;        ///< for how many ticks, if it has room
    bool is_alone = true;  ///< in the tick before
};

/// What the stepping solvers keep of each ball, apart from the ball.
struct SteppingMemory {
    FreeBoxes boxes;
    std::vector<std::size_t> moving;  ///< balls in play that are not stationary, in order
    std::vector<std::size_t> loose;   ///< those that may meet something in this step, in order
    std::vector<Vec2> next;           ///< where a moving ball is at the step's end, m
    std::vector<Outlook> outlooks;
    std::vector<Chord> chords;  ///< exact_arc
    std::vector<Real> ends;     ///< exact_arc: of a contact; when chords begin anew, s
};

}  // namespace poolhall
