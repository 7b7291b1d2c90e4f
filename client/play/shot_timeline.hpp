#pragma once

#include "shared/game/ruleset.hpp"
#include "shared/physics/scene/scene.hpp"
#include "shared/physics/scene/trace.hpp"

#include <optional>
#include <span>
#include <vector>

namespace poolhall::client {

/// Where the balls of one shot are at any time, as far as it is known. Straight between what was
/// received; the exact points of impact are corners of the path, so that a bounce between two ticks
/// is not cut short. Times can be asked for in any order.
class ShotTimeline {
  public:
    /// `positions` (m) of all balls at time `begin` (s since the strike).
    explicit ShotTimeline(std::span<const Vec2> positions, double begin = 0);

    struct Moved {
        BallIndex ball;
        Vec2 r;  ///< m
    };

    /// What happened up to time `t`: impacts in order of time, then where the balls that moved are.
    /// A `t` that is not later than all before is ignored, and so are balls that are not of this
    /// shot.
    void extend(double t, std::span<const ShotEvent> events, std::span<const Moved> moved);
    /// The exact end, in the scene's order of balls; nothing can be added after it.
    void finish(double duration, std::span<const FinalBall> balls);

    [[nodiscard]] bool complete() const { return complete_; }

    [[nodiscard]] double begin() const { return begin_; }

    /// The newest time that is known, s.
    [[nodiscard]] double known_until() const { return known_until_; }

    [[nodiscard]] std::size_t ball_count() const { return tracks_.size(); }

    /// Position at `t`, held within the known time; m.
    [[nodiscard]] Vec2 position(BallIndex ball, double t) const;
    [[nodiscard]] bool sunk(BallIndex ball, double t) const;

    /// In order of time.
    [[nodiscard]] std::span<const ShotEvent> events() const { return events_; }

    /// How many of the events have happened by time `t`: those before that place in events().
    [[nodiscard]] std::size_t events_until(double t) const;

  private:
    struct Knot {
        double t;
        Vec2 r;
    };

    struct Track {
        std::vector<Knot> knots;
        std::optional<double> sunk_at;
    };

    void add_event(const ShotEvent& event, double latest);
    [[nodiscard]] bool of_this_shot(const ShotEvent& event) const;

    std::vector<Track> tracks_;
    std::vector<ShotEvent> events_;
    double begin_;
    double known_until_;
    bool complete_ = false;
};

/// The timeline of a shot that is known whole, from its trace's samples; complete.
[[nodiscard]] ShotTimeline timeline_of(const SimulatedShot& shot);

/// The balls' positions in a scene, in its order; m.
[[nodiscard]] std::vector<Vec2> positions_of(const Scene& scene);

}  // namespace poolhall::client
