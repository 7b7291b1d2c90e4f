#pragma once

#include "shared/physics/simulate.hpp"

#include <algorithm>
#include <vector>

namespace poolhall::testing {

inline std::vector<ShotEvent> events_of(const ShotTrace& trace, EventKind kind) {
    std::vector<ShotEvent> events;
    std::copy_if(trace.events.begin(), trace.events.end(), std::back_inserter(events),
                 [&](const ShotEvent& event) { return event.kind == kind; });
    return events;
}

inline std::size_t count(const ShotTrace& trace, EventKind kind) {
    return events_of(trace, kind).size();
}

inline Vec2 final_place(const ShotTrace& trace, std::size_t ball) {
    return xy(trace.balls[ball].state.r);
}

inline Vec2 final_velocity(const ShotTrace& trace, std::size_t ball) {
    return xy(trace.balls[ball].state.v);
}

}  // namespace poolhall::testing
