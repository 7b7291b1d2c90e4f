#pragma once

#include "shared/enum_names.hpp"
#include "shared/fields.hpp"
#include "shared/physics/effects/effect_account.hpp"
#include "shared/physics/motion/event_kind.hpp"
#include "shared/physics/motion/moving_ball.hpp"
#include "shared/physics/scene/scene.hpp"
#include "shared/table/ball.hpp"
#include "shared/table/table.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace poolhall {

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

    static constexpr auto field_list() {
        return std::tuple{fields::of("t", &ShotEvent::t).in("s"),
                          fields::of("kind", &ShotEvent::kind),
                          fields::of("ball_count", &ShotEvent::ball_count),
                          fields::of("rail", &ShotEvent::rail),
                          fields::of("pocket", &ShotEvent::pocket),
                          fields::of("balls", &ShotEvent::balls),
                          fields::of("before", &ShotEvent::before),
                          fields::of("after", &ShotEvent::after)};
    }

    friend bool operator==(const ShotEvent&, const ShotEvent&) = default;
};

/// How a simulation ended.
enum class Outcome : std::uint8_t {
    kRest,        ///< nothing moves any more
    kTimeLimit,   ///< Limits::time
    kEventLimit,  ///< Limits::events
    kStalled,  ///< more contacts in one tick than kMaxContactsPerTick: a loud error, never a hang
};

constexpr auto enum_names(Outcome /*type*/) {
    return names_of<Outcome>({{Outcome::kRest, "rest"},
                              {Outcome::kTimeLimit, "time_limit"},
                              {Outcome::kEventLimit, "event_limit"},
                              {Outcome::kStalled, "stalled"}});
}

struct FinalBall {
    Motion motion = Motion::kStationary;
    Pocket pocket = Pocket::kNorthWest;  ///< meaningful where motion is kPocketed
    BallState state;                     ///< a pocketed ball keeps the r of its capture, v = w = 0

    static constexpr auto field_list() {
        return std::tuple{fields::of("motion", &FinalBall::motion),
                          fields::of("pocket", &FinalBall::pocket),
                          fields::of("state", &FinalBall::state)};
    }

    friend bool operator==(const FinalBall&, const FinalBall&) = default;
};

/// All of one shot.
struct ShotTrace {
    std::string_view kernel;  ///< name of the effect set that was simulated
    EffectAccount effects;    ///< which of the scene's effects could act, and why others could not
    SolverKind solver = SolverKind::kEuler;
    Outcome outcome = Outcome::kRest;
    Real duration = 0;  ///< time of the last event, or the limit; s
    std::uint64_t ticks = 0;
    std::vector<ShotEvent> events;  ///< in order of time
    std::vector<FinalBall> balls;   ///< in the scene's order
    Real sample_hz = 0;             ///< of `samples`; 0: none asked for
    std::vector<Vec3> samples;      ///< sample k, ball i at [k * balls.size() + i]; m
    std::uint64_t hash = 0;         ///< of events and final states

    /// What a simulation finds; the others say how it was made.
    static constexpr auto field_list() {
        return std::tuple{fields::of("outcome", &ShotTrace::outcome),
                          fields::of("duration", &ShotTrace::duration).in("s"),
                          fields::of("ticks", &ShotTrace::ticks),
                          fields::of("events", &ShotTrace::events),
                          fields::of("balls", &ShotTrace::balls),
                          fields::of("sample_hz", &ShotTrace::sample_hz).in("1/s"),
                          fields::of("samples", &ShotTrace::samples).in("m")};
    }

    [[nodiscard]] std::size_t sample_count() const {
        return balls.empty() ? 0 : samples.size() / balls.size();
    }

    [[nodiscard]] const Vec3& sample(std::size_t k, std::size_t ball) const {
        return samples[k * balls.size() + ball];
    }
};

/// The pocket's name on this table, by which files and messages call it.
[[nodiscard]] std::string_view pocket_id(const Table& table, Pocket pocket);

/// Hash of the events (kind, balls, bits of t) and the bits of the final states in the scene's
/// order.
[[nodiscard]] std::uint64_t hash_of(const ShotTrace& trace);
/// 16 lower-case hex digits.
[[nodiscard]] std::string to_hex(std::uint64_t hash);

}  // namespace poolhall
