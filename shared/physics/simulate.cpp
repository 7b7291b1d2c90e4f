#include "shared/physics/simulate.hpp"

#include "shared/physics/called_for/called_for.hpp"
#include "shared/physics/effects/kernels.hpp"
#include "shared/physics/solvers/solvers.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <tuple>
#include <type_traits>
#include <utility>

namespace poolhall {

namespace {

template <class... Kernel>
constexpr std::array<std::string_view, sizeof...(Kernel)> names_of(
    std::type_identity<std::tuple<Kernel...>>) {
    return {Kernel::kName...};
}

constexpr auto kNames = names_of(std::type_identity<KernelList>{});

/// Which of the kernels cover the effects that may act, in their order.
template <class... Kernel>
auto coverage_of(const EffectAccount& effects,
                 std::type_identity<std::tuple<Kernel...>> /*kernels*/) {
    return std::array<bool, sizeof...(Kernel)>{is_covered<Kernel>(effects)...};
}

/// The first kernel that covers what may act.
std::size_t first_kernel(const EffectAccount& effects) {
    const auto all = coverage_of(effects, std::type_identity<KernelList>{});
    const auto first = std::find(all.begin(), all.end(), true);
    assert(first != all.end());
    return static_cast<std::size_t>(first - all.begin());
}

}  // namespace

void Simulator::run(std::size_t kernel, ShotRun& shot, ShotTrace& trace) {
    const SolverKind solver = shot.scene().solver.kind;
    trace.kernel = kNames[kernel];
    trace.solver = solver;
    solver_of(solver).run(kernel, shot, memories_[static_cast<std::size_t>(solver)]);
}

void Simulator::simulate(const Scene& scene, Real sample_hz, ShotTrace& trace) {
    simulate_what_may_act([&] { return ShotRun(scene, sample_hz, workspace_, trace); }, trace);
}

void Simulator::simulate_many(const Scene& position, std::span<const Strike> strikes,
                              Real sample_hz, std::span<ShotTrace> traces) {
    assert(strikes.size() == traces.size());
    place_balls(position, placed_);
    for (std::size_t i = 0; i < strikes.size(); ++i) {
        const ShotFrom shot{position, strikes[i], placed_};
        simulate_what_may_act([&] { return ShotRun(shot, sample_hz, workspace_, traces[i]); },
                              traces[i]);
    }
}

/// begin() makes the shot as it is after the strike.
template <class Begin>
void Simulator::simulate_what_may_act(Begin begin, ShotTrace& trace) {
    ShotRun shot = begin();
    const Scene& scene = shot.scene();
    const Prospect prospect = prospect_of(scene, shot.balls(), reach_);
    trace.effects = EffectAccount(scene, prospect);
    if (prospect.reach_is_bounded)
        shot.leave_out([&](const MovingBall& ball) { return takes_no_part(ball, prospect); });
    run(first_kernel(trace.effects), shot, trace);
    if (!prospect.reach_is_by_energy || stayed_within(prospect, scene, trace, reach_)) return;
    ShotRun whole = begin();
    trace.effects = EffectAccount(scene, Prospect{});
    run(first_kernel(trace.effects), whole, trace);
}

bool Simulator::simulate_by(std::string_view kernel, const Scene& scene, Real sample_hz,
                            ShotTrace& trace) {
    const auto found = std::find(kNames.begin(), kNames.end(), kernel);
    if (found == kNames.end()) return false;
    const auto place = static_cast<std::size_t>(found - kNames.begin());
    const EffectAccount named(scene, Prospect{});
    if (!coverage_of(named, std::type_identity<KernelList>{})[place])
        return simulate_within_bounds(place, scene, sample_hz, trace);
    ShotRun shot(scene, sample_hz, workspace_, trace);
    trace.effects = named;
    run(place, shot, trace);
    return true;
}

/// By a kernel that has not all that the scene names, if it has all that may act.
bool Simulator::simulate_within_bounds(std::size_t kernel, const Scene& scene, Real sample_hz,
                                       ShotTrace& trace) {
    ShotTrace tried;
    ShotRun shot(scene, sample_hz, workspace_, tried);
    const Prospect prospect = prospect_of(scene, shot.balls(), reach_);
    tried.effects = EffectAccount(scene, prospect);
    if (!coverage_of(tried.effects, std::type_identity<KernelList>{})[kernel]) return false;
    run(kernel, shot, tried);
    if (prospect.reach_is_by_energy && !stayed_within(prospect, scene, tried, reach_)) return false;
    trace = std::move(tried);
    return true;
}

bool has_ticks(SolverKind kind) {
    return solver_of(kind).has_ticks;
}

void simulate(const Scene& scene, Real sample_hz, ShotTrace& trace) {
    Simulator().simulate(scene, sample_hz, trace);
}

ShotTrace simulate(const Scene& scene, Real sample_hz) {
    ShotTrace trace;
    simulate(scene, sample_hz, trace);
    return trace;
}

std::span<const std::string_view> kernel_names() {
    return kNames;
}

bool simulate_by(std::string_view kernel, const Scene& scene, Real sample_hz, ShotTrace& trace) {
    return Simulator().simulate_by(kernel, scene, sample_hz, trace);
}

}  // namespace poolhall
