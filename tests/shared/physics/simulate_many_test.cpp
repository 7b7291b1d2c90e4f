// Shots of one position together: as each alone, however they are split.

#include "shared/physics/simulate.hpp"
#include "tests/shared/scenes.hpp"

#include <gtest/gtest.h>
#include <span>
#include <vector>

namespace poolhall {
namespace {

/// A rack of ten balls on a table with mouths, by ticks or without.
Scene position_by(SolverKind solver) {
    Scene scene = testing::break_scene(4, 1e-4, 5);
    scene.effects = lab::cloth_effects();
    scene.table.pockets = PocketModel::kPool;
    scene.solver = {solver, 60};
    return scene;
}

std::vector<Strike> strikes_at(const Scene& scene) {
    std::vector<Strike> strikes;
    for (int i = 0; i < 24; ++i) {
        Strike strike = *scene.strike;
        strike.direction.y += 0.01 * i;
        strike.speed = 1 + 0.3 * i;
        strike.offset.y = 0.02 * (i % 5);
        strikes.push_back(strike);
    }
    return strikes;
}

class SimulateMany : public ::testing::TestWithParam<SolverKind> {};

INSTANTIATE_TEST_SUITE_P(Solvers, SimulateMany,
                         ::testing::Values(SolverKind::kEuler, SolverKind::kExactArc,
                                           SolverKind::kEvent));

TEST_P(SimulateMany, GivesTheShotsThatOneByOneGive) {
    Scene scene = position_by(GetParam());
    const std::vector<Strike> strikes = strikes_at(scene);
    std::vector<ShotTrace> traces(strikes.size());
    Simulator().simulate_many(scene, strikes, 30, traces);
    for (std::size_t i = 0; i < strikes.size(); ++i) {
        scene.strike = strikes[i];
        const ShotTrace alone = simulate(scene, 30);
        EXPECT_EQ(alone.hash, traces[i].hash);
        EXPECT_EQ(alone.events, traces[i].events);
        EXPECT_EQ(alone.samples, traces[i].samples);
        EXPECT_EQ(alone.kernel, traces[i].kernel);
    }
}

TEST_P(SimulateMany, GivesTheSameBitsHoweverItIsSplit) {
    const Scene scene = position_by(GetParam());
    const std::vector<Strike> strikes = strikes_at(scene);
    std::vector<ShotTrace> whole(strikes.size());
    Simulator().simulate_many(scene, strikes, 0, whole);
    for (const std::size_t part : {1U, 5U, 23U}) {
        std::vector<ShotTrace> traces(strikes.size());
        Simulator first;
        Simulator second;
        const std::span<const Strike> all(strikes);
        second.simulate_many(scene, all.subspan(part), 0, std::span(traces).subspan(part));
        first.simulate_many(scene, all.first(part), 0, std::span(traces).first(part));
        for (std::size_t i = 0; i < strikes.size(); ++i)
            EXPECT_EQ(whole[i].hash, traces[i].hash) << part << ' ' << i;
    }
}

TEST(SimulateManyMemory, KeepsNothingOfAnotherPosition) {
    const Scene mouths = position_by(SolverKind::kEvent);
    Scene smaller = mouths;
    smaller.table.length = 2.2;
    smaller.balls.resize(5);
    Simulator simulator;
    std::vector<ShotTrace> traces(24);
    simulator.simulate_many(mouths, strikes_at(mouths), 0, traces);
    simulator.simulate_many(smaller, strikes_at(smaller), 0, traces);
    std::vector<ShotTrace> fresh(24);
    Simulator().simulate_many(smaller, strikes_at(smaller), 0, fresh);
    for (std::size_t i = 0; i < traces.size(); ++i)
        EXPECT_EQ(fresh[i].hash, traces[i].hash);
}

}  // namespace
}  // namespace poolhall
