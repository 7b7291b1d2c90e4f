#pragma once

#include "shared/physics/effects/linear_drag.hpp"
#include "shared/physics/shot_run.hpp"

#include <algorithm>
#include <cstdint>

namespace poolhall {

/// Runs `tick(begin, end)` (s) at the scene's rate until nothing moves or a limit is reached. A
/// tick answers kRest when it went well, and otherwise how the shot ends. Times are k / hz, not a
/// sum, so that rates agree on the instants they share.
template <class Tick>
void run_ticks(ShotRun& run, Tick tick) {
    const double hz = run.scene().solver.hz;
    const double limit = run.scene().limits.time;
    std::uint64_t ticks = 0;
    double t = 0;
    run.sample_at(0);
    Outcome outcome = Outcome::kRest;
    while (outcome == Outcome::kRest && run.any_moves()) {
        if (run.event_limit_reached()) {
            outcome = Outcome::kEventLimit;
        } else if (t >= limit) {
            outcome = Outcome::kTimeLimit;
        } else {
            const double end = std::min(static_cast<double>(ticks + 1) / hz, limit);
            outcome = tick(t, end);
            t = end;
            ++ticks;
        }
    }
    run.finish(outcome, t, ticks);
}

/// Lets the drag act on every ball at the end of a tick of `dt` s.
inline void slow_down(ShotRun& run, const LinearDrag& drag, double dt, double end) {
    for (std::size_t i = 0; i < run.balls().size(); ++i) {
        MovingBall& ball = run.balls()[i];
        if (ball.v == Vec2{}) continue;
        const MovingBall before = ball;
        ball.v = drag.euler_step(ball.v, dt);
        if (ball.v == Vec2{}) run.record_rest(end, i, before);
    }
}

}  // namespace poolhall
