#include "client/lab/accuracy/shot_errors.hpp"

#include "shared/analysis/agreement.hpp"

#include <algorithm>
#include <cmath>

namespace poolhall::lab {

namespace {

/// Over the ball's mass, m^2/s^2: of its way and, as a solid sphere, of its spin.
double energy_of(const BallState& state, double radius) {
    return dot(state.v, state.v) / 2 + radius * radius * dot(state.w, state.w) / 5;
}

double energy_after(const ShotEvent& event, double radius) {
    double sum = 0;
    for (std::size_t i = 0; i < event.ball_count; ++i)
        sum += energy_of(event.after[i], radius);
    return sum;
}

/// Right after the strike.
double energy_at_start(const Scene& scene, const ShotTrace& trace) {
    double sum = 0;
    for (const SceneBall& ball : scene.balls)
        sum += energy_of(ball.state, scene.ball.radius);
    if (scene.strike) sum += energy_after(trace.events.front(), scene.ball.radius);
    return sum;
}

/// Of the balls of each event that both have, right after it.
double energy_drift(const Scene& scene, const ShotTrace& reference, const ShotTrace& other,
                    const analysis::Agreement& both) {
    double largest = 0;
    for (const auto& [true_place, place] : both.matching) {
        const double off = energy_after(other.events[place], scene.ball.radius) -
                           energy_after(reference.events[true_place], scene.ball.radius);
        largest = std::max(largest, std::abs(off));
    }
    return largest / energy_at_start(scene, reference);
}

const ShotEvent* first_impact(const ShotTrace& trace) {
    const auto found = std::find_if(trace.events.begin(), trace.events.end(), analysis::is_impact);
    return found == trace.events.end() ? nullptr : &*found;
}

std::optional<ImpactErrors> impact_errors(const ShotTrace& reference, const ShotTrace& other) {
    const ShotEvent* const expected = first_impact(reference);
    const ShotEvent* const actual = first_impact(other);
    if (!expected || !actual || !analysis::is_same_event(*expected, *actual)) return std::nullopt;
    ImpactErrors errors{std::abs(actual->t - expected->t)};
    for (std::size_t i = 0; i < expected->ball_count; ++i) {
        // The two balls may stand in the other order.
        const std::size_t j = actual->balls[i] == expected->balls[i] ? i : 1 - i;
        const BallState& state = expected->after[i];
        errors.place = std::max(errors.place, norm(actual->after[j].r - state.r));
        errors.velocity = std::max(errors.velocity, norm(actual->after[j].v - state.v));
    }
    return errors;
}

}  // namespace

ShotErrors errors_of(const Scene& scene, const ShotTrace& reference, const ShotTrace& other) {
    const analysis::Agreement both = analysis::agreement(reference, other);
    const auto [missed, invented] = analysis::compare_collisions(reference, other);
    ShotErrors errors;
    errors.rest = analysis::farthest_at_rest(reference, other);
    errors.impact = impact_errors(reference, other);
    errors.energy_drift = energy_drift(scene, reference, other, both);
    errors.matching_events = static_cast<double>(both.matching.size());
    errors.horizon = both.horizon;
    errors.verdict_flips = !analysis::is_same_verdict(reference, other);
    errors.missed = static_cast<double>(missed);
    errors.invented = static_cast<double>(invented);
    return errors;
}

}  // namespace poolhall::lab
