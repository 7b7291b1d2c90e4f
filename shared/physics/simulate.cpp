#include "shared/physics/simulate.hpp"

#include "shared/physics/effects/kernels.hpp"
#include "shared/physics/solvers/solvers.hpp"

#include <array>
#include <cassert>
#include <tuple>
#include <type_traits>

namespace poolhall {

namespace {

/// Which of the kernels cover the scene, in their order.
template <class... Kernel>
constexpr auto coverage_of(const Scene& scene, std::type_identity<std::tuple<Kernel...>>) {
    return std::array<bool, sizeof...(Kernel)>{Kernel::template covers<AllEffects>(scene)...};
}

template <class... Kernel>
constexpr std::array<std::string_view, sizeof...(Kernel)> names_of(
    std::type_identity<std::tuple<Kernel...>>) {
    return {Kernel::kName...};
}

constexpr auto kNames = names_of(std::type_identity<KernelList>{});

/// The first kernel that covers the scene and that `wanted` accepts by name; kNames.size() if there
/// is none.
template <class Wanted>
std::size_t first_kernel(const Scene& scene, Wanted wanted) {
    const auto covers = coverage_of(scene, std::type_identity<KernelList>{});
    std::size_t kernel = 0;
    while (kernel < kNames.size() && !(covers[kernel] && wanted(kNames[kernel])))
        ++kernel;
    return kernel;
}

}  // namespace

void Simulator::run(std::size_t kernel, ShotRun& shot, ShotTrace& trace) {
    const SolverKind solver = shot.scene().solver.kind;
    trace.kernel = kNames[kernel];
    trace.solver = solver;
    solver_of(solver).run(kernel, shot, memories_[static_cast<std::size_t>(solver)]);
}

void Simulator::simulate(const Scene& scene, Real sample_hz, ShotTrace& trace) {
    const std::size_t kernel = first_kernel(scene, [](std::string_view) { return true; });
    assert(kernel < kNames.size());
    ShotRun shot(scene, sample_hz, workspace_, trace);
    run(kernel, shot, trace);
}

void Simulator::simulate_many(const Scene& position, std::span<const Strike> strikes,
                              Real sample_hz, std::span<ShotTrace> traces) {
    assert(strikes.size() == traces.size());
    const std::size_t kernel = first_kernel(position, [](std::string_view) { return true; });
    place_balls(position, placed_);
    for (std::size_t i = 0; i < strikes.size(); ++i) {
        ShotRun shot({position, strikes[i], placed_}, sample_hz, workspace_, traces[i]);
        run(kernel, shot, traces[i]);
    }
}

bool Simulator::simulate_by(std::string_view kernel, const Scene& scene, Real sample_hz,
                            ShotTrace& trace) {
    const std::size_t found =
        first_kernel(scene, [&](std::string_view name) { return name == kernel; });
    if (found == kNames.size()) return false;
    ShotRun shot(scene, sample_hz, workspace_, trace);
    run(found, shot, trace);
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
