// Ticks of balls that meet nothing, by each kernel and by the loop written by hand for the same
// effects. Checks that both give the bits of the euler solver; kernel_cost_test.py counts from
// outside how many instructions each takes. Prints "10 kernels, 32768 steps each".

#include "shared/physics/simulate.hpp"
#include "tests/bench/hand_written.hpp"

#include <algorithm>
#include <iostream>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

namespace poolhall {
namespace {

constexpr int kTicks = 512;
constexpr int kBalls = 64;  // so many that what a tick costs besides does not matter
constexpr double kHz = 64;  // a power of 2, so that all ticks are equally long to the bit

/// The loop for the effects of a kernel.
template <class Kernel>
struct LoopFor;

template <>
struct LoopFor<OpenCloth> : std::type_identity<hand_written::Glide> {};

template <>
struct LoopFor<RailsOnly> : std::type_identity<hand_written::Glide> {};

template <>
struct LoopFor<DragRails> : std::type_identity<hand_written::Drag> {};

template <>
struct LoopFor<DragRailsPockets> : std::type_identity<hand_written::Drag> {};

template <>
struct LoopFor<Roll> : std::type_identity<hand_written::Roll> {};

template <>
struct LoopFor<SlideRoll> : std::type_identity<hand_written::SlideRoll> {};

template <>
struct LoopFor<SlideRollSpin> : std::type_identity<hand_written::SlideRollSpin> {};

template <>
struct LoopFor<SlideRollSpinEndGame> : std::type_identity<hand_written::SlideRollSpin> {};

template <>
struct LoopFor<SlideRollSpinMouths> : std::type_identity<hand_written::SlideRollSpin> {};

template <>
struct LoopFor<Everything> : std::type_identity<hand_written::Everything> {};

// Not inlined, and with a counter each, so that the compiler makes no two of them one: callgrind
// counts them apart.

template <class Kernel>
std::size_t steps_by_kernel = 0;
template <class Kernel>
std::size_t steps_by_hand = 0;

template <class Kernel>
[[gnu::noinline]] void tick_by_kernel(const Cloth<Kernel>& cloth, std::span<MovingBall> balls,
                                      double dt, std::size_t& ended) {
    steps_by_kernel<Kernel> += balls.size();
    const auto step = cloth.step_of(dt);
    for (MovingBall& ball : balls) {
        ball.r = ball.r + dt * ball.v;
        if constexpr (Kernel::template kHas<Airborne>) ball.height = ball.height + dt * ball.climb;
        cloth.kick(ball, step, [&ended](EventKind, const MovingBall&) { ++ended; });
    }
}

template <class Kernel>
[[gnu::noinline]] void tick_by_hand(const typename LoopFor<Kernel>::type& loop,
                                    std::span<MovingBall> balls, double dt, std::size_t& ended) {
    steps_by_hand<Kernel> += balls.size();
    loop.tick(balls, dt, ended);
}

/// Slow and fast balls, with spin and without, in lanes of a table so wide that they meet nothing.
/// They slide about as long as they roll, and some stop.
template <class Kernel>
Scene scene_for() {
    Scene scene;
    scene.table.length = scene.table.width = 400;
    scene.table.rails = Kernel::kName != OpenCloth::kName;
    if constexpr (Kernel::template kHas<EndGamePockets>)
        scene.table.pockets = PocketModel::kEndGame;
    if constexpr (Kernel::template kHas<PoolMouths>) scene.table.pockets = PocketModel::kPool;
    if constexpr (Kernel::template kHas<LinearDrag>)
        scene.effects.linear_drag = LinearDragSpec{0.2};
    if constexpr (Kernel::template kHas<Sliding>) scene.effects.sliding = SlidingSpec{0.03};
    if constexpr (Kernel::template kHas<Rolling>) scene.effects.rolling = RollingSpec{};
    if constexpr (Kernel::template kHas<SpinDecay>) scene.effects.spin_decay = SpinDecaySpec{};
    if constexpr (Kernel::template kHas<Airborne>) scene.effects.airborne = AirborneSpec{};
    scene.solver.hz = kHz;
    scene.limits.time = kTicks / kHz;
    for (int i = 0; i < kBalls; ++i) {
        BallState state;
        const int kind = i % 16;
        state.r = {-2.0 * kind, -160 + 5.0 * i, 0};
        state.v = {0.2 + 0.3 * kind, 0.01 * kind, 0};
        if (kind % 2 == 0) state.w = {3.0 * kind, -60 + 5.0 * kind, 10.0 * kind};
        if (scene.effects.airborne && kind % 4 == 3) state.v.z = 3.0 * kind;
        scene.balls.push_back({std::to_string(i), state});
    }
    return scene;
}

/// The scene's balls at its beginning, settled.
template <class Kernel>
std::vector<MovingBall> balls_of(const Scene& scene, const Cloth<Kernel>& cloth) {
    std::vector<MovingBall> balls;
    for (const SceneBall& one : scene.balls) {
        MovingBall ball;
        ball.r = xy(one.state.r);
        ball.v = xy(one.state.v);
        ball.w = one.state.w;
        ball.climb = one.state.v.z;
        ball.radius = scene.ball.radius;
        ball.reach = ball.radius;
        ball.mass = scene.ball.mass;
        cloth.settle(ball);
        balls.push_back(ball);
    }
    return balls;
}

/// Whether the balls are as they are at the end of the trace, to the bit, and as much has ended.
bool agree(const ShotTrace& trace, const std::vector<MovingBall>& balls, std::size_t ended) {
    const auto is_same = [](const MovingBall& ball, const FinalBall& result) {
        return ball.motion == result.motion && state_of(ball) == result.state;
    };
    return trace.ticks == kTicks && trace.events.size() == ended &&
           std::equal(balls.begin(), balls.end(), trace.balls.begin(), trace.balls.end(), is_same);
}

template <class Kernel>
bool compare() {
    const Scene scene = scene_for<Kernel>();
    const Kernel effects(scene);
    const Cloth<Kernel> cloth(effects, scene.gravity);
    const typename LoopFor<Kernel>::type loop(scene);
    std::vector<MovingBall> by_kernel = balls_of(scene, cloth);
    std::vector<MovingBall> by_hand = by_kernel;
    std::size_t ended_by_kernel = 0;
    std::size_t ended_by_hand = 0;
    for (int tick = 0; tick < kTicks; ++tick) {
        tick_by_kernel<Kernel>(cloth, by_kernel, 1 / scene.solver.hz, ended_by_kernel);
        tick_by_hand<Kernel>(loop, by_hand, 1 / scene.solver.hz, ended_by_hand);
    }
    for (std::size_t i = 0; i < kBalls; ++i) {
        cloth.update_spin(by_kernel[i]);
        cloth.update_spin(by_hand[i]);
    }
    ShotTrace trace;
    if (steps_by_kernel<Kernel> == steps_by_hand<Kernel> && !check(scene) &&
        simulate_by(Kernel::kName, scene, 0, trace) && agree(trace, by_kernel, ended_by_kernel) &&
        agree(trace, by_hand, ended_by_hand))
        return true;
    std::cerr << Kernel::kName << ": kernel, loop and solver do not agree\n";
    return false;
}

template <class... Kernel>
bool compare_all(std::type_identity<std::tuple<Kernel...>>) {
    return (compare<Kernel>() && ...);
}

}  // namespace
}  // namespace poolhall

int main() {
    using Kernels = poolhall::KernelList;
    if (!poolhall::compare_all(std::type_identity<Kernels>{})) return 1;
    std::cout << std::tuple_size_v<Kernels> << " kernels, " << poolhall::kTicks * poolhall::kBalls
              << " steps each\n";
}
