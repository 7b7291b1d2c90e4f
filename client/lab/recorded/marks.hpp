#pragma once

#include "client/lab/recorded/recording.hpp"

#include <vector>

namespace poolhall::lab {

/// What a recorded shot shows at a glance, from which a fit can begin.
struct ShotMarks {
    Vec2 direction;         ///< of the cue ball's first way, unit
    double speed = 0;       ///< of the cue ball at first, m/s
    double third_rail = 0;  ///< s: when the cue ball meets its third rail; the end if it does not
    double end = 0;         ///< s: of the last sample
    /// s, ascending, the last is the end: a little after each contact. What happens up to one of
    /// them is told apart by the samples up to it, so a fit goes from one to the next.
    std::vector<double> horizons;
};

[[nodiscard]] ShotMarks marks_of(const RecordedShot& shot);

}  // namespace poolhall::lab
