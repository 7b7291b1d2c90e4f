#pragma once

#include "client/play/playback.hpp"
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

/// Where balls met each other and the rails in the shot that is shown, or was shown last.
class CollisionMarks {
  public:
    void pass(const Playback::Passed& passed);

    void toggle() { shown_ = !shown_; }

    /// Collision mode is on. The marks are kept without it too.
    [[nodiscard]] bool shown() const { return shown_; }

    [[nodiscard]] const std::vector<CollisionMark>& marks() const { return marks_; }

  private:
    std::vector<CollisionMark> marks_;
    bool shown_ = false;
};

}  // namespace poolhall::client
