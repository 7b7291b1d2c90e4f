#include "shared/physics/scene/trace.hpp"

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

void add(StateHash& hash, const BallBallSpec& spec) {
    add(hash, spec.model);
    hash.add(spec.e);
    hash.add(spec.mu);
    hash.add(std::uint64_t{spec.friction_by_speed.has_value()});
    if (spec.friction_by_speed) {
        hash.add(spec.friction_by_speed->a);
        hash.add(spec.friction_by_speed->b);
        hash.add(spec.friction_by_speed->c);
    }
    hash.add(spec.min_separation);
}

void add(StateHash& hash, const RailSpec& spec) {
    add(hash, spec.model);
    hash.add(spec.e);
    hash.add(spec.mu);
    hash.add(spec.nose_height);
}

/// An effect that may be absent, by its one coefficient.
template <class Spec>
void add(StateHash& hash, const std::optional<Spec>& spec, Real Spec::*coefficient) {
    hash.add(std::uint64_t{spec.has_value()});
    if (spec) hash.add((*spec).*coefficient);
}

void add(StateHash& hash, const Effects& effects) {
    add(hash, effects.linear_drag, &LinearDragSpec::k);
    add(hash, effects.linear_drag, &LinearDragSpec::stop_speed);
    add(hash, effects.sliding, &SlidingSpec::mu);
    add(hash, effects.rolling, &RollingSpec::mu);
    add(hash, effects.spin_decay, &SpinDecaySpec::mu);
    add(hash, effects.airborne, &AirborneSpec::e_slate);
    add(hash, effects.ball_ball);
    add(hash, effects.rail);
}

void add(StateHash& hash, const Table& table) {
    hash.add(table.length);
    hash.add(table.width);
    hash.add(std::uint64_t{table.rails});
    add(hash, table.pockets);
    for (const PocketCircle& circle : table.circles) {
        add(hash, circle.id);
        hash.add(Vec3{circle.centre.x, circle.centre.y, circle.radius});
    }
}

void add(StateHash& hash, const Strike& strike) {
    hash.add(std::uint64_t{strike.ball.value});
    hash.add(Vec3{strike.direction.x, strike.direction.y, 0});
    hash.add(strike.speed);
    hash.add(Vec3{strike.offset.x, strike.offset.y, strike.elevation});
    hash.add(strike.end_mass_ratio);
}

}  // namespace

std::string_view name(EventKind kind) {
    constexpr std::array<std::string_view, 9> kNames{
        "strike",        "roll_to_rest", "ball_ball", "ball_rail", "ball_pocket",
        "slide_to_roll", "spin_to_rest", "bounce",    "off_table"};
    return kNames[static_cast<std::size_t>(kind)];
}

std::string_view name(Outcome outcome) {
    constexpr std::array<std::string_view, 4> kNames{"rest", "time_limit", "event_limit",
                                                     "stalled"};
    return kNames[static_cast<std::size_t>(outcome)];
}

std::string_view name(Motion motion) {
    constexpr std::array<std::string_view, 7> kNames{
        "stationary", "rolling", "pocketed", "sliding", "spinning", "airborne", "off_table"};
    return kNames[static_cast<std::size_t>(motion)];
}

std::string_view name(SolverKind kind) {
    constexpr std::array<std::string_view, 5> kNames{"euler", "overlap", "semi_implicit",
                                                     "exact_arc", "event"};
    return kNames[static_cast<std::size_t>(kind)];
}

std::string_view pocket_id(const Table& table, Pocket pocket) {
    if (table.pockets == PocketModel::kCircles)
        return table.circles[static_cast<std::size_t>(pocket)].id;
    return name(pocket);
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
    add(hash, scene.table);
    hash.add(scene.ball.radius);
    hash.add(scene.ball.mass);
    hash.add(scene.gravity);
    add(hash, scene.effects);
    add(hash, scene.solver.kind);
    hash.add(scene.solver.hz);
    for (const SceneBall& ball : scene.balls) {
        add(hash, ball.id);
        add(hash, ball.state);
        hash.add(radius_of(scene, ball));
        hash.add(mass_of(scene, ball));
    }
    hash.add(scene.limits.time);
    hash.add(std::uint64_t{scene.limits.events});
    hash.add(std::uint64_t{scene.strike.has_value()});
    if (scene.strike) add(hash, *scene.strike);
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
