#pragma once

#include "shared/physics/scene.hpp"
#include "shared/physics/trace.hpp"

#include <limits>
#include <vector>

namespace poolhall {

/// A ball while it is simulated. The effects that there are leave height and spin alone, so only
/// the plane is here.
struct MovingBall {
    static constexpr std::size_t kNobody = std::numeric_limits<std::size_t>::max();

    Vec2 r;  ///< m
    Vec2 v;  ///< m/s
    bool in_play = true;
    /// The ball met last, until anything else happens to either. Two bodies that move uniformly
    /// after their impact do not meet again, but rounding could say so near grazing.
    std::size_t partner = kNobody;
};

/// A shot in progress: its balls, and the trace that is written of it. The solvers drive it.
class ShotRun {
  public:
    /// Puts the balls on the table and delivers the strike.
    ShotRun(const Scene& scene, double sample_hz, ShotTrace& trace);

    [[nodiscard]] std::vector<MovingBall>& balls() { return balls_; }

    [[nodiscard]] const Scene& scene() const { return scene_; }

    [[nodiscard]] bool any_moves() const;

    [[nodiscard]] bool event_limit_reached() const {
        return trace_.events.size() >= scene_.limits.events;
    }

    void record_pair(double t, std::size_t a, std::size_t b, const MovingBall& before_a,
                     const MovingBall& before_b);
    void record_rail(double t, std::size_t ball, Rail rail, const MovingBall& before);
    /// Takes the ball off the table.
    void capture(double t, std::size_t ball, Pocket pocket);
    /// The ball has stopped.
    void record_rest(double t, std::size_t ball, const MovingBall& before);

    [[nodiscard]] std::size_t event_count() const { return trace_.events.size(); }

    /// Puts the events from the given one on in order of time; those at the same instant stay as
    /// they came.
    void sort_events_from(std::size_t first);

    /// Writes the samples due in [from, to) while the balls move uniformly, their places being
    /// those at `from`.
    void sample_between(double from, double to);
    /// Writes the samples due up to t, the balls' places being those at t.
    void sample_at(double t);

    /// Completes the trace. `t` is the time reached.
    void finish(Outcome outcome, double t, std::uint64_t ticks);

  private:
    void strike();
    [[nodiscard]] BallState state_of(std::size_t ball, const MovingBall& moving) const;
    ShotEvent& add_event(double t, EventKind kind, std::size_t ball, const MovingBall& before);

    /// After a sample was written. Times are k / hz, not a sum.
    void set_next_sample() { next_sample_ = static_cast<double>(++samples_) / trace_.sample_hz; }

    const Scene& scene_;
    ShotTrace& trace_;
    std::vector<MovingBall> balls_;
    std::uint64_t samples_ = 0;
    double next_sample_ = std::numeric_limits<double>::infinity();  ///< s; when it is due
};

}  // namespace poolhall
