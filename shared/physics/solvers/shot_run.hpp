#pragma once

#include "shared/physics/contact/contact.hpp"
#include "shared/physics/motion/moving_ball.hpp"
#include "shared/physics/scene/scene.hpp"
#include "shared/physics/scene/trace.hpp"
#include "shared/physics/search/cushion_map.hpp"

#include <span>
#include <vector>

namespace poolhall {

/// From so many balls on the solvers search by strips of the table and a tournament; below, it
/// costs less to look through all. Measured (PHYSICS.md).
inline constexpr std::size_t kManyBalls = 24;

/// The memory that a shot by any solver needs besides its trace; used again, so that a second shot
/// with no more balls and events than the first allocates nothing. What one solver needs besides is
/// its own (SolverMemory).
struct Workspace {
    std::size_t many_balls = kManyBalls;
    std::vector<MovingBall> balls;    ///< that take part
    std::vector<BallIndex> in_scene;  ///< where each of them is in the scene
    ContactSolver contact_solver;
    KeptCushionMap cushions;
    // What happens in one instant.
    std::vector<Contact> contacts;
    std::vector<MovingBall> before;  ///< two a contact: the balls before it was resolved
};

/// Writes the balls of a scene as they are before its strike.
void place_balls(const Scene& scene, std::vector<MovingBall>& balls);

/// One shot of many from the same position: a strike in place of the scene's own, and the scene's
/// balls, from place_balls().
struct ShotFrom {
    const Scene& scene;
    const Strike& strike;
    std::span<const MovingBall> balls;
};

/// A shot in progress: its balls, and the trace that is written of it. The solvers drive it.
class ShotRun {
  public:
    /// Puts the balls on the table and delivers the strike.
    ShotRun(const Scene& scene, Real sample_hz, Workspace& workspace, ShotTrace& trace);
    ShotRun(const ShotFrom& shot, Real sample_hz, Workspace& workspace, ShotTrace& trace);

    /// Leaves out of the simulation the balls of which `takes_no_part(ball)`: those stay where they
    /// are. To be called before anything happens, if at all.
    template <class TakesNoPart>
    void leave_out(TakesNoPart takes_no_part) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < balls().size(); ++i) {
            if (takes_no_part(balls()[i])) continue;
            balls()[kept] = balls()[i];
            workspace_.in_scene[kept++] = workspace_.in_scene[i];
        }
        balls().resize(kept);
        workspace_.in_scene.resize(kept);
    }

    /// Those that take part, in the scene's order.
    [[nodiscard]] std::vector<MovingBall>& balls() { return workspace_.balls; }

    [[nodiscard]] Workspace& workspace() const { return workspace_; }

    [[nodiscard]] const Scene& scene() const { return scene_; }

    [[nodiscard]] bool any_moves() const;

    [[nodiscard]] bool event_limit_reached() const {
        return trace_.events.size() >= scene_.limits.events;
    }

    [[nodiscard]] std::size_t event_count() const { return trace_.events.size(); }

    /// What happened to one ball: any kind but strike, ball_ball, ball_rail and ball_pocket.
    void record(Real t, EventKind kind, std::size_t ball, const MovingBall& before);
    void record_pair(Real t, std::size_t a, std::size_t b, const MovingBall& before_a,
                     const MovingBall& before_b);
    void record_rail(Real t, std::size_t ball, Rail rail, const MovingBall& before);
    /// Takes the ball off the table, into a pocket.
    void capture(Real t, std::size_t ball, Pocket pocket);
    /// The ball leaves the table over a rail.
    void lose(Real t, std::size_t ball);

    /// Puts the events from the given one on in order of time; those at the same instant stay as
    /// they came.
    void sort_events_from(std::size_t first);

    /// When the next sample is due, s; infinity where none is asked for.
    [[nodiscard]] Real next_sample() const { return next_sample_; }

    /// Writes one sample: place(i) is where ball i is then.
    template <class Place>
    void sample(Place place) {
        std::size_t i = 0;
        for (std::size_t ball = 0; ball < scene_.balls.size(); ++ball) {
            const bool takes_part = i < balls().size() && workspace_.in_scene[i].value == ball;
            trace_.samples.push_back(takes_part ? place(i++) : scene_.balls[ball].state.r);
        }
        next_sample_ = static_cast<Real>(++samples_) / trace_.sample_hz;
    }

    /// Writes the samples due before `until` (s); place_after(i, time) says where ball i is `time`
    /// s after `from`.
    template <class PlaceAfter>
    void sample_before(Real until, Real from, PlaceAfter place_after) {
        while (next_sample_ < until) {
            const Real passed = next_sample_ - from;
            sample([&](std::size_t i) { return place_after(i, passed); });
        }
    }

    /// Writes the samples due up to t, the balls' places being those at t.
    void sample_at(Real t);

    /// Completes the trace. `t` is the time reached.
    void finish(Outcome outcome, Real t, std::uint64_t ticks);

  private:
    void begin(Real sample_hz);
    void deliver(const Strike& strike);
    void end_samples();
    /// Ends the ball's part in the shot.
    ShotEvent& take_away(Real t, std::size_t ball, Motion to, EventKind kind);
    ShotEvent& add_event(Real t, EventKind kind, std::size_t ball, const MovingBall& before);

    const Scene& scene_;
    ShotTrace& trace_;
    Workspace& workspace_;
    std::uint64_t samples_ = 0;
    Real next_sample_ = kInfinity;  ///< s; when it is due
};

}  // namespace poolhall
