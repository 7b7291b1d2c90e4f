#pragma once

#include "shared/physics/motion/moving_ball.hpp"
#include "shared/physics/scene/scene.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace poolhall {

/// Values enter the trace's hash: new ones go to the end.
enum class EventKind : std::uint8_t {
    kStrike,
    kRollToRest,
    kBallBall,
    kBallRail,
    kBallPocket,
    kSlideToRoll,
    kSpinToRest,
    kBounce,    ///< on the slate
    kOffTable,  ///< over a rail
};

/// Something that happened at an instant. One or two balls take part (ball_count); where it is one,
/// the second places mean nothing. `rail` and `pocket` mean something only for their kinds.
struct ShotEvent {
    ShotEvent() = default;

    /// What happened to one ball.
    ShotEvent(Real time, EventKind what, BallIndex ball, const MovingBall& was,
              const MovingBall& is)
        : t(time),
          kind(what),
          balls{ball, {}},
          before{state_of(was), {}},
          after{state_of(is), {}} {}

    Real t = 0;  ///< s since the strike
    EventKind kind = EventKind::kStrike;
    std::uint8_t ball_count = 1;
    Rail rail = Rail::kNorth;
    Pocket pocket = Pocket::kNorthWest;  ///< or an index into Table::circles; see pocket_id()
    std::array<BallIndex, 2> balls;
    std::array<BallState, 2> before;
    std::array<BallState, 2> after;

    friend bool operator==(const ShotEvent&, const ShotEvent&) = default;
};

/// How a simulation ended.
enum class Outcome : std::uint8_t {
    kRest,        ///< nothing moves any more
    kTimeLimit,   ///< Limits::time
    kEventLimit,  ///< Limits::events
    kStalled,  ///< more contacts in one tick than kMaxContactsPerTick: a loud error, never a hang
};

struct FinalBall {
    Motion motion = Motion::kStationary;
    Pocket pocket = Pocket::kNorthWest;  ///< meaningful where motion is kPocketed
    BallState state;                     ///< a pocketed ball keeps the r of its capture, v = w = 0

    friend bool operator==(const FinalBall&, const FinalBall&) = default;
};

/// All of one shot.
struct ShotTrace {
    std::string_view kernel;  ///< name of the effect set that was simulated
    SolverKind solver = SolverKind::kEuler;
    Outcome outcome = Outcome::kRest;
    Real duration = 0;  ///< time of the last event, or the limit; s
    std::uint64_t ticks = 0;
    std::vector<ShotEvent> events;  ///< in order of time
    std::vector<FinalBall> balls;   ///< in the scene's order
    Real sample_hz = 0;             ///< of `samples`; 0: none asked for
    std::vector<Vec3> samples;      ///< sample k, ball i at [k * balls.size() + i]; m
    std::uint64_t hash = 0;         ///< of events and final states

    [[nodiscard]] std::size_t sample_count() const {
        return balls.empty() ? 0 : samples.size() / balls.size();
    }

    [[nodiscard]] const Vec3& sample(std::size_t k, std::size_t ball) const {
        return samples[k * balls.size() + ball];
    }
};

/// "strike", "roll_to_rest", "ball_ball", "ball_rail", "ball_pocket", "slide_to_roll",
/// "spin_to_rest", "bounce", "off_table".
[[nodiscard]] std::string_view name(EventKind kind);
/// "rest", "time_limit", "event_limit", "stalled".
[[nodiscard]] std::string_view name(Outcome outcome);
/// "stationary", "rolling", "pocketed", "sliding", "spinning", "airborne", "off_table".
[[nodiscard]] std::string_view name(Motion motion);
/// "euler", "overlap", "semi_implicit", "exact_arc", "event".
[[nodiscard]] std::string_view name(SolverKind kind);

/// The pocket's name on this table, by which files and messages call it.
[[nodiscard]] std::string_view pocket_id(const Table& table, Pocket pocket);

/// Hash of the events (kind, balls, bits of t) and the bits of the final states in the scene's
/// order.
[[nodiscard]] std::uint64_t hash_of(const ShotTrace& trace);
/// Hash of all that determines the shot, ids included: two machines that agree on it simulate the
/// same.
[[nodiscard]] std::uint64_t hash_of(const Scene& scene);
/// 16 lower-case hex digits.
[[nodiscard]] std::string to_hex(std::uint64_t hash);

}  // namespace poolhall
