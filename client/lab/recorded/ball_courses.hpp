#pragma once

#include "shared/physics/scene/scene.hpp"
#include "shared/physics/scene/trace.hpp"

#include <cstddef>
#include <vector>

namespace poolhall::lab {

/// Where each ball of a trace of `event` was, at any time: between two events of a ball its way is
/// a parabola, of which the trace has both ends and both velocities. Exact for balls on cloth.
class BallCourses {
  public:
    /// Takes the place of the courses before, in the same memory.
    void set(const Scene& scene, const ShotTrace& trace);

    /// A stretch of a ball's way.
    struct Stretch {
        double t = 0;  ///< s, from when on
        Vec2 r;        ///< m, at t
        Vec2 v;        ///< m/s, at t
        Vec2 a;        ///< m/s^2
    };

    /// In order of time, the first at 0; the last stands for ever if the ball rests.
    [[nodiscard]] const std::vector<Stretch>& of(std::size_t ball) const { return courses_[ball]; }

    /// Until when they are known, s.
    [[nodiscard]] double end() const { return end_; }

  private:
    std::vector<std::vector<Stretch>> courses_;
    double end_ = 0;
};

/// The place at `t`, from a stretch that begins no later.
[[nodiscard]] inline Vec2 place_on(const BallCourses::Stretch& stretch, double t) {
    const double passed = t - stretch.t;
    return stretch.r + passed * stretch.v + (passed * passed / 2) * stretch.a;
}

}  // namespace poolhall::lab
