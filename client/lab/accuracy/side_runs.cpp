#include "client/lab/accuracy/side_runs.hpp"

#include "client/lab/corpora/bench_scenes.hpp"
#include "client/lab/corpora/scene_makers.hpp"
#include "shared/physics/simulate.hpp"

#include <algorithm>
#include <array>

namespace poolhall::lab {

namespace {

constexpr std::array<double, 11> kSpeeds{0.5, 1, 1.5, 2, 3, 4, 5, 7, 10, 15, 30};  // m/s

constexpr std::array kTunnellers{
    SolverSpec{SolverKind::kOverlap, 30}, SolverSpec{SolverKind::kOverlap, 60},
    SolverSpec{SolverKind::kOverlap, 120}, SolverSpec{SolverKind::kOverlap, 480},
    SolverSpec{SolverKind::kEuler, 30}};

constexpr std::array kCrowdSolvers{
    SolverSpec{SolverKind::kEuler, 30}, SolverSpec{SolverKind::kEuler, 120},
    SolverSpec{SolverKind::kEuler, 480}, SolverSpec{SolverKind::kExactArc, 30},
    SolverSpec{SolverKind::kEvent, SolverSpec{}.hz}};

/// Hits the ball at the origin, by a hair at least.
Scene certain_hit(Random& random, const SolverSpec& solver, double speed) {
    const double contact = 2 * BallSpec{}.radius;
    const double start = 0.5 + random.uniform(0, 1) * speed / solver.hz;
    Scene scene = scene_of({{-start, 0.999999 * contact * random.uniform(-1, 1)}, {0, 0}});
    scene.table.rails = false;
    set_xy(scene.balls[0].state.v, {speed, 0});
    scene.limits.time = (start + contact) / speed + 2 / solver.hz;
    scene.solver = solver;
    return scene;
}

double share_missed(const RunPlan& plan, const SolverSpec& solver, double speed) {
    const int shots = plan.quick ? 400 : 5000;
    Random random(plan.seed);
    Simulator simulator;
    ShotTrace trace;
    int missed = 0;
    for (int shot = 0; shot < shots; ++shot) {
        simulator.simulate(certain_hit(random, solver, speed), 0, trace);
        missed += trace.events.empty() ? 1 : 0;
    }
    return static_cast<double>(missed) / shots;
}

}  // namespace

std::optional<std::vector<Tunnelling>> run_tunnelling(const RunPlan& plan, Progress& progress) {
    progress.begin("tunnelling", kTunnellers.size() * kSpeeds.size());
    std::vector<Tunnelling> all;
    for (const SolverSpec& solver : kTunnellers) {
        Tunnelling& one = all.emplace_back();
        one.solver = solver;
        for (const double speed : kSpeeds) {
            if (Interruption::asked_for()) return std::nullopt;
            one.speed.push_back(speed);
            one.missed.push_back(share_missed(plan, solver, speed));
            progress.step();
        }
    }
    return all;
}

std::optional<std::vector<CrowdCosts>> run_crowds(const RunPlan& plan, Progress& progress) {
    constexpr std::size_t kMost = 256;
    constexpr std::size_t kSizes = 8;
    progress.begin("crowds", kCrowdSolvers.size() * kSizes);
    std::vector<CrowdCosts> all;
    Simulator simulator;
    ShotTrace trace;
    for (const SolverSpec& solver : kCrowdSolvers) {
        CrowdCosts& one = all.emplace_back();
        one.solver = solver;
        for (std::size_t balls = 2; balls <= kMost; balls *= 2) {
            if (Interruption::asked_for()) return std::nullopt;
            Scene scene = crowd(balls);
            scene.solver = solver;
            const Cost cost = measure([&] { simulator.simulate(scene, 0, trace); }, plan.repeats());
            one.balls.push_back(balls);
            one.ns.push_back(cost.ns);
            progress.step();
        }
    }
    return all;
}

}  // namespace poolhall::lab
