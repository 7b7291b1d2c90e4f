#include "tests/shared/invariants.hpp"
#include "tests/shared/random.hpp"
#include "tests/shared/scenes.hpp"
#include "tests/shared/solvers.hpp"

#include <chrono>
#include <cstdio>
#include <gtest/gtest.h>

namespace poolhall {
namespace {

/// Three to fifteen balls with gaps of a micrometre to a centimetre, struck from anywhere behind
/// the head string.
Scene random_break(testing::Random& random) {
    const double gap = random.below(2) == 0 ? random.uniform(1e-6, 1e-3) : random.uniform(0, 1e-2);
    Scene scene =
        testing::break_scene(2 + static_cast<int>(random.below(4)), gap, random.uniform(0.5, 13));
    scene.effects = random.below(2) == 0 ? testing::cloth_effects() : testing::pool_effects();
    Vec3& cue = scene.balls[0].state.r;
    cue = {random.uniform(-1.2, -0.7), random.uniform(-0.5, 0.5), 0};
    const Vec2 target{0.6, random.uniform(-0.1, 0.1)};
    scene.strike->direction = target - xy(cue);
    scene.strike->offset = random.uniform(0, 0.5) * random.direction();
    scene.solver.kind = SolverKind::kEvent;
    return scene;
}

TEST(MillionBreaks, NoneStallsAndNoneBreaksAnInvariant) {
    constexpr int kBreaks = 1'000'000;
    constexpr auto kLongest = std::chrono::minutes(20);
    const auto begin = std::chrono::steady_clock::now();
    testing::Random random(81);
    Simulator simulator;
    ShotTrace trace;
    std::size_t events = 0;
    std::size_t most = 0;
    int done = 0;
    // The places of every hundredth: to look at all would take longer than to simulate them.
    for (; done < kBreaks && std::chrono::steady_clock::now() - begin < kLongest; ++done) {
        const Scene scene = random_break(random);
        simulator.simulate(scene, done % 100 == 0 ? 30 : 0, trace);
        ASSERT_EQ(Outcome::kRest, trace.outcome) << done;
        ASSERT_EQ("", testing::broken_invariant(scene, trace, 1e-12)) << done;
        events += trace.events.size();
        most = std::max(most, trace.events.size());
    }
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    std::printf("%d breaks, %.0f a second, %.1f events a break, at most %zu\n", done,
                done / passed.count(), static_cast<double>(events) / done, most);
}

}  // namespace
}  // namespace poolhall
