#pragma once

#include "client/play/shot_timeline.hpp"
#include "client/play/view_state.hpp"

#include <span>
#include <vector>

namespace poolhall::client {

/// The rings that step mode leaves behind the balls; they fade with each further step.
class StepTrail {
  public:
    static constexpr int kLife = 48;  ///< steps until a ring is gone

    /// A step led from one set of positions to the other; balls that moved leave a ring where they
    /// were.
    void step(std::span<const Vec2> before, std::span<const Vec2> after);

    void clear() { rings_.clear(); }

    [[nodiscard]] const std::vector<TrailRing>& rings() const { return rings_; }

  private:
    std::vector<TrailRing> rings_;
};

/// Where balls have met each other and the rails by time `t` of the shot, s.
[[nodiscard]] std::vector<CollisionMark> collision_marks(const ShotTimeline& timeline, double t);

}  // namespace poolhall::client
