#pragma once

#include "shared/physics/search/free_boxes.hpp"
#include "shared/table/table.hpp"

#include <cstddef>
#include <vector>

namespace poolhall {

/// How a ball's box is made.
struct BoxPlan {
    Vec2 clear;            ///< up to which |x| and |y| its centre meets nothing of the table, m
    Real ticks = 1;        ///< for how many ticks, if it has room
    bool is_alone = true;  ///< in the tick before
};

struct FoundCapture {
    std::size_t ball;
    Pocket pocket;
};

/// The memory of InstantSearch, and with it of the stepping solvers.
struct SteppingMemory {
    FreeBoxes boxes;
    std::vector<std::size_t> moving;  ///< balls in play that are not stationary, in order
    std::vector<std::size_t> loose;   ///< those that may meet something in this step, in order
    std::vector<Vec2> next;           ///< where a moving ball is at the step's end, m
    std::vector<BoxPlan> plans;
    // What happens first; contacts are in the workspace.
    std::vector<FoundCapture> captures;
    std::vector<std::size_t> transitions;  ///< balls
};

}  // namespace poolhall
