#pragma once

#include "shared/physics/solvers/shot_run.hpp"

#include <algorithm>
#include <cstdint>

namespace poolhall {

/// More instants than this within one tick end the shot as stalled: balls that are this fast are no
/// pool.
inline constexpr int kMaxContactsPerTick = 10000;

/// What a tick answers where it does not end the shot, which goes on towards rest.
inline constexpr Outcome kGoesOn = Outcome::kRest;

/// Runs `tick(begin, end)` (s) at the scene's rate as long as `any_moves()` or until a limit is
/// reached. A tick answers how the shot ends with it, or kGoesOn. `at_end()` may
/// then bring the balls up to date. Times are k / hz, not a sum, so that rates agree on the
/// instants they share.
template <class AnyMoves, class Tick, class AtEnd>
void run_ticks(ShotRun& run, AnyMoves any_moves, Tick tick, AtEnd at_end) {
    const Real hz = run.scene().solver.hz;
    const Real limit = run.scene().limits.time;
    std::uint64_t ticks = 0;
    Real t = 0;
    run.sample_at(0);
    Outcome outcome = kGoesOn;
    while (outcome == kGoesOn && any_moves()) {
        if (run.event_limit_reached()) {
            outcome = Outcome::kEventLimit;
        } else if (t >= limit) {
            outcome = Outcome::kTimeLimit;
        } else {
            const Real end = std::min(static_cast<Real>(ticks + 1) / hz, limit);
            outcome = tick(t, end);
            t = end;
            ++ticks;
        }
    }
    at_end();
    run.finish(outcome, t, ticks);
}

}  // namespace poolhall
