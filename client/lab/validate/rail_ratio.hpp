#pragma once

#include "shared/physics/contact/rail_spec.hpp"

namespace poolhall::lab {

/// What a recording at 50 Hz would make of a rolling carom ball (61.5 mm) that meets that rail
/// squarely at `speed` m/s: its speed after the rail over that before, each the slope of a straight
/// line through five samples, so that some 0.1 s of slip are in it.
[[nodiscard]] double rail_ratio(const RailSpec& rail, double speed);

}  // namespace poolhall::lab
