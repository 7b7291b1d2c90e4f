#pragma once

#include "shared/physics/motion/arc.hpp"
#include "shared/physics/search/boxes.hpp"
#include "shared/physics/search/course.hpp"
#include "shared/physics/search/own_event.hpp"
#include "shared/physics/search/pair_times.hpp"
#include "shared/physics/search/soonest.hpp"

#include <vector>

namespace poolhall {

/// The memory of the solver event, of each ball.
struct EventMemory {
    std::vector<Arc> arcs;
    std::vector<OwnEvent> own;
    std::vector<Course> courses;
    Boxes reach;  ///< of the arc up to its own event
    PairTimes pairs;
    Soonest due;  ///< own event or meeting
};

}  // namespace poolhall
