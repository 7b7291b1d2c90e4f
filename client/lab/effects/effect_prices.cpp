#include "client/lab/effects/effect_prices.hpp"

#include "shared/physics/simulate.hpp"

#include <algorithm>
#include <cassert>

namespace poolhall::lab {

namespace {

constexpr SolverSpec kStepping{SolverKind::kSemiImplicit, 120};

Price divided(const Cost& cost, double pieces) {
    Price price{cost.ns / pieces, {}};
    if (cost.instructions) price.instructions = *cost.instructions / pieces;
    return price;
}

/// Of all the shots once.
Cost cost_of(const std::vector<Scene>& shots, const Repeats& repeats, Callgrind* callgrind) {
    Simulator simulator;
    ShotTrace trace;
    Cost cost = measure(
        [&] {
            for (const Scene& scene : shots)
                simulator.simulate(scene, 0, trace);
        },
        repeats);
    if (callgrind != nullptr) cost.instructions = callgrind->instructions_of(shots);
    return cost;
}

/// What `count` gives for the traces, added up.
template <class Count>
double sum_over(const std::vector<Scene>& shots, Count count) {
    Simulator simulator;
    ShotTrace trace;
    std::size_t sum = 0;
    for (const Scene& scene : shots) {
        simulator.simulate(scene, 0, trace);
        sum += count(scene, trace);
    }
    return static_cast<double>(sum);
}

std::optional<Price> price_of_ball_step(std::vector<Scene>& shots, const Repeats& repeats,
                                        Callgrind* callgrind) {
    for (Scene& scene : shots) {
        scene.solver = kStepping;
        if (check(scene)) return std::nullopt;
    }
    const double steps = sum_over(shots, [](const Scene& scene, const ShotTrace& trace) {
        return trace.ticks * scene.balls.size();
    });
    return divided(cost_of(shots, repeats, callgrind), steps);
}

}  // namespace

ShotPrices prices_of(std::vector<Scene> shots, const Repeats& repeats, Callgrind* callgrind) {
    const Cost cost = cost_of(shots, repeats, callgrind);
    const double events = sum_over(
        shots, [](const Scene& /*scene*/, const ShotTrace& trace) { return trace.events.size(); });
    return {divided(cost, static_cast<double>(shots.size())), divided(cost, std::max(events, 1.0)),
            price_of_ball_step(shots, repeats, callgrind)};
}

Price price_of(const std::vector<Scene>& shots, const Repeats& repeats) {
    return divided(cost_of(shots, repeats, nullptr), static_cast<double>(shots.size()));
}

Price price_by(std::string_view kernel, const std::vector<Scene>& shots, const Repeats& repeats) {
    Simulator simulator;
    ShotTrace trace;
    bool covered = true;
    const Cost cost = measure(
        [&] {
            for (const Scene& scene : shots)
                covered = simulator.simulate_by(kernel, scene, 0, trace) && covered;
        },
        repeats);
    assert(covered);
    return divided(cost, static_cast<double>(shots.size()));
}

}  // namespace poolhall::lab
