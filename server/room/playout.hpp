#pragma once

#include "protocol/messages.hpp"
#include "shared/game/game_state.hpp"

#include <chrono>
#include <cstdint>

namespace poolhall::server {

/// A shot that has been simulated to its end and is now shown, tick by tick at kPlayoutHz.
class Playout {
  public:
    /// `outcome.trace` must hold samples at kPlayoutHz. `shot` counts from 1 within the match;
    /// `cpu` is what its simulation cost.
    Playout(std::uint32_t shot, ShotOutcome outcome, std::chrono::nanoseconds cpu);

    /// The frame of `tick`, with all that happened since the last one asked for; ticks may be
    /// skipped. `tick` must lie above the last and not above last_tick().
    [[nodiscard]] protocol::Frame advance(std::uint32_t tick);

    [[nodiscard]] std::uint32_t tick() const { return tick_; }

    [[nodiscard]] bool finished() const { return tick_ == last_tick(); }

    /// That of the last sample; 1 for a shot that is over at once, so that its events are shown.
    [[nodiscard]] std::uint32_t last_tick() const;
    /// Where the balls are now, for those who come late.
    [[nodiscard]] protocol::LiveShot live() const;

    [[nodiscard]] std::uint32_t shot() const { return shot_; }

    [[nodiscard]] const ShotOutcome& outcome() const { return outcome_; }

    [[nodiscard]] std::chrono::nanoseconds cpu() const { return cpu_; }

  private:
    /// Where the ball is at the tick, m.
    [[nodiscard]] Vec2 place(std::size_t ball, std::uint32_t tick) const;

    std::uint32_t shot_;
    std::uint32_t tick_ = 0;
    std::size_t next_event_ = 0;
    ShotOutcome outcome_;
    std::chrono::nanoseconds cpu_;
};

/// `newer` as a client that missed `older` needs it: balls that moved in either, the events of
/// both. Both belong to one shot, `older` to the earlier tick.
[[nodiscard]] protocol::Frame merge(const protocol::Frame& older, const protocol::Frame& newer);

}  // namespace poolhall::server
