#include "client/desktop/app/step_mode.hpp"

namespace poolhall::client {

void StepMode::toggle() {
    const bool on = !on_;
    *this = {};
    on_ = on;
}

void StepMode::looked(double now, bool at_end) {
    last_look_ = now;
    at_end_ = on_ && at_end;
}

bool StepMode::takes(double now) {
    if (!on_) return false;
    const bool rested = now - last_look_ >= kPause;
    if (rested && !at_end_) return false;
    if (rested) at_end_ = false;
    last_look_ = now;
    return true;
}

}  // namespace poolhall::client
