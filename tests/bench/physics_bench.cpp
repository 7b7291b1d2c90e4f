// What the simulation costs. Every benchmark checks its answer before it times it. CSV:
// --benchmark_format=csv; the compiler, its flags and the processor stand in the context.

#include "client/lab/corpora/bench_scenes.hpp"
#include "client/lab/output/build_info.hpp"
#include "shared/game/end_game.hpp"
#include "shared/physics/contact/time_of_impact.hpp"
#include "shared/physics/simulate.hpp"

#include <benchmark/benchmark.h>
#include <cmath>
#include <cstdint>
#include <string>

namespace poolhall {
namespace {

/// The first shot of the end game, a thin cut: 2 balls, 1 impact, several rails, 6 s.
Scene end_game_shot() {
    GameState state = kEndGameRules.new_game(Seat{0});
    state.scene.strike = Strike{state.cue_ball, {1, 0.031}, end_game::kShotSpeed};
    return state.scene;
}

constexpr std::string_view kHashOfTheShot = "4fa26df63a5da8aa";

bool shot_is_right(benchmark::State& state, const ShotTrace& trace) {
    if (to_hex(trace.hash) == kHashOfTheShot) return true;
    state.SkipWithError(("the shot's hash is " + to_hex(trace.hash)).c_str());
    return false;
}

/// A whole shot to rest; the argument is the rate of its samples, 0 for none.
void whole_shot(benchmark::State& state) {
    const Scene scene = end_game_shot();
    const auto sample_hz = static_cast<double>(state.range(0));
    ShotTrace trace;
    simulate(scene, sample_hz, trace);
    if (!shot_is_right(state, trace)) return;
    for ([[maybe_unused]] auto _ : state) {
        simulate(scene, sample_hz, trace);
        benchmark::DoNotOptimize(trace.hash);
    }
    state.counters["ticks"] = static_cast<double>(trace.ticks);
    state.counters["events"] = static_cast<double>(trace.events.size());
}

/// One 30 Hz tick of two balls under drag, with rails and pockets, far from any contact: the time
/// of 600 ticks, divided.
void tick_of_two_balls(benchmark::State& state) {
    constexpr std::uint64_t kTicks = 600;
    Scene scene = kEndGameRules.new_game(Seat{0}).scene;
    scene.effects.linear_drag->stop_speed = 0;
    scene.limits.time = kTicks / 30.0;
    scene.balls[0].state.v = {0.01, 0, 0};
    scene.balls[1].state.v = {-0.01, 0.01, 0};
    ShotTrace trace;
    simulate(scene, 0, trace);
    if (trace.ticks != kTicks || !trace.events.empty()) {
        state.SkipWithError("the balls met something");
        return;
    }
    for ([[maybe_unused]] auto _ : state) {
        simulate(scene, 0, trace);
        benchmark::DoNotOptimize(trace.hash);
    }
    state.counters["per_tick"] = benchmark::Counter(
        kTicks, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// A whole shot of 16 balls that begin with 2 m/s each and slide, roll, meet each other and the
/// rails, by Euler's steps; the argument is their rate. `per_ball_step` is its time over ticks and
/// balls.
void shot_of_sixteen_balls(benchmark::State& state) {
    Scene scene = lab::crowd(16);
    scene.effects.spin_decay.reset();
    scene.effects.ball_ball.model = BallBallModel::kRestitution;
    scene.effects.rail.model = RailModel::kRestitution;
    scene.solver = {SolverKind::kEuler, static_cast<double>(state.range(0))};
    Simulator simulator;
    ShotTrace trace;
    ShotTrace other;
    simulator.simulate(scene, 0, trace);
    if (trace.kernel != "slide_roll" || trace.outcome != Outcome::kRest ||
        !simulator.simulate_by("everything", scene, 0, other) || other.hash != trace.hash) {
        state.SkipWithError("not the shot that it should be");
        return;
    }
    for ([[maybe_unused]] auto _ : state) {
        simulator.simulate(scene, 0, trace);
        benchmark::DoNotOptimize(trace.hash);
    }
    state.counters["ticks"] = static_cast<double>(trace.ticks);
    state.counters["events"] = static_cast<double>(trace.events.size());
    state.counters["per_ball_step"] = benchmark::Counter(
        static_cast<double>(trace.ticks * scene.balls.size()),
        benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// The argument: 0 a full hit, 1 a miss, 2 a graze by 1e-7 rad, which takes double-double.
void impact(benchmark::State& state) {
    constexpr double kDiameter = 2 * BallSpec{}.radius;
    const double offset = state.range(0) == 0   ? 0
                          : state.range(0) == 1 ? 0.5
                                                : kDiameter * (1 - 0.5e-14);
    UniformMotion cue{{0, 0}, {3, 0}};
    UniformMotion object{{1, offset}, {0, 0}};
    const auto t = time_of_impact(cue, object, kDiameter);
    const double way = std::sqrt((kDiameter - offset) * (kDiameter + offset));
    if (t.has_value() != (offset <= kDiameter) || (t && std::abs(*t * 3 - (1 - way)) > 1e-15)) {
        state.SkipWithError("wrong time of impact");
        return;
    }
    for ([[maybe_unused]] auto _ : state) {
        benchmark::DoNotOptimize(cue);
        benchmark::DoNotOptimize(object);
        benchmark::DoNotOptimize(time_of_impact(cue, object, kDiameter));
    }
}

BENCHMARK(tick_of_two_balls);
BENCHMARK(whole_shot)->ArgName("sample_hz")->Arg(0)->Arg(30)->Unit(benchmark::kMicrosecond);
BENCHMARK(shot_of_sixteen_balls)
    ->ArgName("hz")
    ->Arg(30)
    ->Arg(60)
    ->Arg(120)
    ->Arg(240)
    ->Arg(480)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(impact)->ArgName("full0_miss1_graze2")->DenseRange(0, 2);

}  // namespace
}  // namespace poolhall

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    const poolhall::lab::BuildInfo info = poolhall::lab::build_info();
    benchmark::AddCustomContext("compiler", info.compiler);
    benchmark::AddCustomContext("flags", info.flags);
    benchmark::AddCustomContext("processor", info.processor);
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
}
