#include "shared/physics/trace.hpp"

#include "shared/math/state_hash.hpp"

namespace poolhall {

namespace {

void add(StateHash& hash, const BallState& state) {
    hash.add(state.r);
    hash.add(state.v);
    hash.add(state.w);
}

void add(StateHash& hash, std::string_view text) {
    hash.add(std::uint64_t{text.size()});
    for (const char c : text)
        hash.add(std::uint64_t{static_cast<unsigned char>(c)});
}

template <class Enum>
requires std::is_enum_v<Enum>

void add(StateHash& hash, Enum value) {
    hash.add(static_cast<std::uint64_t>(value));
}

void add(StateHash& hash, const Effects& effects) {
    hash.add(std::uint64_t{effects.linear_drag.has_value()});
    if (effects.linear_drag) {
        hash.add(effects.linear_drag->k);
        hash.add(effects.linear_drag->stop_speed);
    }
    add(hash, effects.ball_ball.model);
    add(hash, effects.rail.model);
    hash.add(effects.rail.e);
}

}  // namespace

std::string_view name(EventKind kind) {
    constexpr std::array<std::string_view, 5> kNames{"strike", "roll_to_rest", "ball_ball",
                                                     "ball_rail", "ball_pocket"};
    return kNames[static_cast<std::size_t>(kind)];
}

std::string_view name(Outcome outcome) {
    constexpr std::array<std::string_view, 4> kNames{"rest", "time_limit", "event_limit",
                                                     "stalled"};
    return kNames[static_cast<std::size_t>(outcome)];
}

std::string_view name(Motion motion) {
    constexpr std::array<std::string_view, 3> kNames{"stationary", "rolling", "pocketed"};
    return kNames[static_cast<std::size_t>(motion)];
}

std::string_view name(SolverKind kind) {
    constexpr std::array<std::string_view, 2> kNames{"euler", "overlap"};
    return kNames[static_cast<std::size_t>(kind)];
}

std::uint64_t hash_of(const ShotTrace& trace) {
    StateHash hash;
    for (const ShotEvent& event : trace.events) {
        add(hash, event.kind);
        for (std::size_t i = 0; i < event.ball_count; ++i)
            hash.add(std::uint64_t{event.balls[i].value});
        hash.add(event.t);
    }
    for (const FinalBall& ball : trace.balls) {
        add(hash, ball.motion);
        add(hash, ball.state);
    }
    return hash.value();
}

std::uint64_t hash_of(const Scene& scene) {
    StateHash hash;
    hash.add(scene.table.length);
    hash.add(scene.table.width);
    hash.add(std::uint64_t{scene.table.rails});
    add(hash, scene.table.pockets);
    hash.add(scene.ball.radius);
    hash.add(scene.ball.mass);
    hash.add(scene.gravity);
    add(hash, scene.effects);
    add(hash, scene.solver.kind);
    hash.add(scene.solver.hz);
    for (const SceneBall& ball : scene.balls) {
        add(hash, ball.id);
        add(hash, ball.state);
    }
    hash.add(scene.limits.time);
    hash.add(std::uint64_t{scene.limits.events});
    hash.add(std::uint64_t{scene.strike.has_value()});
    if (scene.strike) {
        hash.add(std::uint64_t{scene.strike->ball.value});
        hash.add(Vec3{scene.strike->direction.x, scene.strike->direction.y, 0});
        hash.add(scene.strike->speed);
    }
    return hash.value();
}

std::string to_hex(std::uint64_t hash) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text(16, '0');
    for (std::size_t i = text.size(); i-- > 0; hash >>= 4U)
        text[i] = kDigits[hash & 15U];
    return text;
}

}  // namespace poolhall
