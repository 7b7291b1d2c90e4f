#pragma once

#include "client/lab/reference/simulation_113.hpp"
#include "shared/physics/scene/scene.hpp"
#include "shared/physics/scene/trace.hpp"

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

// How scenes and traces are written to a tape and read from it. Each field is listed once; both
// compilations include this, so that what one writes the other reads.
namespace poolhall::lab {

template <class T, class Named>
concept Is = std::same_as<std::remove_const_t<T>, Named>;

// --- fields: all that a shot depends on, and all that it gives. Names of balls and circles stay.
// ---

void list(auto& tape, Is<Vec2> auto& a) {
    tape(a.x, a.y);
}

void list(auto& tape, Is<Vec3> auto& a) {
    tape(a.x, a.y, a.z);
}

void list(auto& tape, Is<BallIndex> auto& index) {
    tape(index.value);
}

void list(auto& tape, Is<BallState> auto& state) {
    tape(state.r, state.v, state.w);
}

void list(auto& tape, Is<BallSpec> auto& ball) {
    tape(ball.radius, ball.mass);
}

void list(auto& tape, Is<PocketCircle> auto& circle) {
    tape(circle.centre, circle.radius);
}

void list(auto& tape, Is<Table> auto& table) {
    tape(table.length, table.width, table.rails, table.pockets, table.circles);
}

void list(auto& tape, Is<LinearDragSpec> auto& spec) {
    tape(spec.k, spec.stop_speed);
}

void list(auto& tape, Is<SlidingSpec> auto& spec) {
    tape(spec.mu);
}

void list(auto& tape, Is<RollingSpec> auto& spec) {
    tape(spec.mu);
}

void list(auto& tape, Is<SpinDecaySpec> auto& spec) {
    tape(spec.mu);
}

void list(auto& tape, Is<FrictionBySpeed> auto& friction) {
    tape(friction.a, friction.b, friction.c);
}

void list(auto& tape, Is<BallBallSpec> auto& spec) {
    tape(spec.model, spec.e, spec.mu, spec.friction_by_speed, spec.min_separation);
}

void list(auto& tape, Is<RailSpec> auto& spec) {
    tape(spec.model, spec.e, spec.mu, spec.nose_height);
}

void list(auto& tape, Is<AirborneSpec> auto& spec) {
    tape(spec.e_slate);
}

void list(auto& tape, Is<Effects> auto& effects) {
    tape(effects.linear_drag, effects.sliding, effects.rolling, effects.spin_decay,
         effects.ball_ball, effects.rail, effects.airborne);
}

void list(auto& tape, Is<SceneBall> auto& ball) {
    tape(ball.state, ball.radius, ball.mass);
}

void list(auto& tape, Is<Limits> auto& limits) {
    tape(limits.time, limits.events);
}

void list(auto& tape, Is<Strike> auto& strike) {
    tape(strike.ball, strike.direction, strike.speed, strike.offset, strike.elevation,
         strike.end_mass_ratio);
}

void list(auto& tape, Is<Scene> auto& scene) {
    tape(scene.table, scene.ball, scene.gravity, scene.effects, scene.balls, scene.limits,
         scene.strike);
}

void list(auto& tape, Is<ShotEvent> auto& event) {
    tape(event.t, event.kind, event.ball_count, event.rail, event.pocket, event.balls, event.before,
         event.after);
}

void list(auto& tape, Is<FinalBall> auto& ball) {
    tape(ball.motion, ball.pocket, ball.state);
}

void list(auto& tape, Is<ShotTrace> auto& trace) {
    tape(trace.outcome, trace.duration, trace.ticks, trace.events, trace.balls, trace.sample_hz,
         trace.samples);
}

// --- tapes ---------------------------------------------------------------------------------------

/// Appends what it is given.
class TapeWriter {
  public:
    /// The tape is overwritten.
    explicit TapeWriter(poolhall_reference::Tape& tape) : tape_(tape) { tape_.clear(); }

    template <class... T>
    void operator()(const T&... fields) {
        (write(fields), ...);
    }

  private:
    void write(Real x) {
        const auto value = static_cast<double>(x);
        tape_.push_back({value, static_cast<double>(x - value)});
    }

    template <class T>
    requires std::is_enum_v<T> || std::integral<T>

    void write(T x) { tape_.push_back({static_cast<double>(x), 0}); }

    template <class T>
    void write(const std::optional<T>& x) {
        write(x.has_value());
        if (x) write(*x);
    }

    template <class T, std::size_t kSize>
    void write(const std::array<T, kSize>& all) {
        for (const T& x : all)
            write(x);
    }

    template <class T>
    void write(const std::vector<T>& all) {
        write(all.size());
        for (const T& x : all)
            write(x);
    }

    template <class T>
    requires std::is_class_v<T>

    void write(const T& x) { list(*this, x); }

    poolhall_reference::Tape& tape_;
};

/// Takes fields from a tape, in the order in which they were written.
class TapeReader {
  public:
    /// What of its numbers is read into a Real. Counts and names are whole in their values.
    enum class Part { kValue, kRest, kSum };

    TapeReader(const poolhall_reference::Tape& tape, Part part) : tape_(tape), part_(part) {}

    template <class... T>
    void operator()(T&... fields) {
        (read(fields), ...);
    }

  private:
    void read(Real& x) {
        const auto& [value, rest] = tape_[next_++];
        x = part_ == Part::kSum ? Real{value} + rest : part_ == Part::kRest ? rest : value;
    }

    template <class T>
    requires std::is_enum_v<T> || std::integral<T>

    void read(T& x) { x = static_cast<T>(static_cast<std::int64_t>(tape_[next_++].value)); }

    template <class T>
    void read(std::optional<T>& x) {
        bool has_value = false;
        read(has_value);
        x.reset();
        if (has_value) read(x.emplace());
    }

    template <class T, std::size_t kSize>
    void read(std::array<T, kSize>& all) {
        for (T& x : all)
            read(x);
    }

    template <class T>
    void read(std::vector<T>& all) {
        std::size_t size = 0;
        read(size);
        all.resize(size);
        for (T& x : all)
            read(x);
    }

    template <class T>
    requires std::is_class_v<T>

    void read(T& x) { list(*this, x); }

    const poolhall_reference::Tape& tape_;
    Part part_;
    std::size_t next_ = 0;
};

}  // namespace poolhall::lab
