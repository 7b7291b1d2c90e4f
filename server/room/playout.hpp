#pragma once

#include "protocol/messages.hpp"
#include "shared/match/match.hpp"

#include <chrono>
#include <cstdint>
#include <utility>

namespace poolhall::server {

/// A shot that has been simulated to its end and is now shown, tick by tick at kPlayoutHz. It keeps
/// the step of the match that the shot will have been once it has been shown.
class Playout {
  public:
    /// The step must be that of a shot, with samples at kPlayoutHz. `cpu` is what its simulation
    /// cost.
    Playout(MatchStep step, std::chrono::nanoseconds cpu);

    /// The frame of `tick`, with all that happened since the last one asked for; ticks may be
    /// skipped. `tick` must lie above the last and not above last_tick().
    [[nodiscard]] protocol::Frame advance(std::uint32_t tick);

    [[nodiscard]] std::uint32_t tick() const { return tick_; }

    [[nodiscard]] bool finished() const { return tick_ == last_tick(); }

    /// That of the last sample; 1 for a shot that is over at once, so that its events are shown.
    [[nodiscard]] std::uint32_t last_tick() const;
    /// Where the balls are now, for those who come late.
    [[nodiscard]] protocol::LiveShot live() const;

    [[nodiscard]] const MatchStep& step() const { return step_; }

    [[nodiscard]] MatchStep take_step() && { return std::move(step_); }

    [[nodiscard]] const ShotTaken& shot() const { return *step_.shot(); }

    [[nodiscard]] const ShotTrace& trace() const { return shot().simulated.trace; }

    /// What is told when the shot begins, to those who simulate it themselves with the final hash.
    [[nodiscard]] protocol::ShotStarted started(protocol::Stream stream) const;
    /// What is told once it has been shown, but for the table after it.
    [[nodiscard]] protocol::ShotEnded ended() const;

  private:
    /// Where the ball is at the tick, m.
    [[nodiscard]] Vec2 place(std::size_t ball, std::uint32_t tick) const;

    MatchStep step_;
    std::chrono::nanoseconds cpu_;
    std::uint32_t tick_ = 0;
    std::size_t next_event_ = 0;
};

}  // namespace poolhall::server
