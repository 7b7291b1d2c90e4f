#include "shared/game/settings.hpp"

#include "shared/game/end_game.hpp"
#include "shared/physics/simulate.hpp"
#include "tests/shared/game/played_shot.hpp"
#include "tests/shared/game/pool_settings.hpp"
#include "tests/shared/random.hpp"

#include <gtest/gtest.h>
#include <limits>
#include <string>

namespace poolhall {
namespace {

const Ruleset& kRules = kEndGameRules;

Effects pool_effects() {
    return test::pool_settings().effects.value();
}

constexpr SolverSpec kEvent{SolverKind::kEvent, 30};

/// What the check blames, "" if nothing.
std::string blamed(const GameSettings& settings) {
    const auto error = check(kRules, settings);
    return error ? error->pointer : std::string();
}

std::string blamed(const Effects& effects) {
    return blamed(GameSettings{effects, kEvent});
}

TEST(GameSettings, NoneLeaveTheGameAsItIs) {
    EXPECT_EQ("", blamed(GameSettings{}));
    EXPECT_EQ(kRules.new_game(Seat{1}), new_game(kRules, Seat{1}, {}));
}

TEST(GameSettings, ReplaceEffectsAndSolverAndNothingElseButTheLimits) {
    const GameState state = new_game(kRules, Seat{0}, {pool_effects(), kEvent});
    GameState own = kRules.new_game(Seat{0});
    EXPECT_EQ(pool_effects(), state.scene.effects);
    EXPECT_EQ(kEvent, state.scene.solver);
    own.scene.effects = pool_effects();
    own.scene.solver = kEvent;
    own.scene.limits = kGameLimits;
    EXPECT_EQ(own, state);
}

TEST(GameSettings, LeaveTheGamesOwnWhatTheyDoNotName) {
    const GameState own = kRules.new_game(Seat{0});
    EXPECT_EQ(own.scene.effects, new_game(kRules, Seat{0}, {{}, kEvent}).scene.effects);
    EXPECT_EQ(own.scene.solver, new_game(kRules, Seat{0}, {pool_effects(), {}}).scene.solver);
    EXPECT_EQ("", blamed(GameSettings{{}, kEvent}));
    EXPECT_EQ("", blamed(GameSettings{pool_effects(), {}}));
}

TEST(GameSettings, EverySolverButOverlapMayBePlayed) {
    for (const SolverKind kind :
         {SolverKind::kEuler, SolverKind::kSemiImplicit, SolverKind::kExactArc, SolverKind::kEvent})
        EXPECT_EQ("", blamed({pool_effects(), SolverSpec{kind, 120}}));
    EXPECT_EQ("/solver/kind", blamed({pool_effects(), SolverSpec{SolverKind::kOverlap, 120}}));
}

TEST(GameSettings, BallsMustComeToRest) {
    Effects effects;
    EXPECT_EQ("/effects", blamed(effects)) << "nothing slows them";
    effects.sliding = SlidingSpec{};
    effects.spin_decay = SpinDecaySpec{};
    EXPECT_EQ("/effects", blamed(effects)) << "a ball that rolls rolls on";
    effects.rolling = RollingSpec{0};
    EXPECT_EQ("/effects", blamed(effects)) << "0 is absent";
    effects.rolling = RollingSpec{1e-6};
    EXPECT_EQ("/effects/rolling/mu", blamed(effects));
    effects.rolling = RollingSpec{};
    EXPECT_EQ("", blamed(effects));
    effects.sliding = SlidingSpec{1e-6};
    EXPECT_EQ("/effects/sliding/mu", blamed(effects)) << "it would never begin to roll";
    effects.sliding = SlidingSpec{0};
    EXPECT_EQ("", blamed(effects));
    effects.spin_decay = SpinDecaySpec{1e-6};
    EXPECT_EQ("/effects/spin_decay/mu", blamed(effects));
}

TEST(GameSettings, DragMustStopTheBallsAndLetThemStart) {
    const auto with_drag = [](double k, double stop_speed) {
        Effects effects;
        effects.linear_drag = LinearDragSpec{k, stop_speed};
        return blamed(effects);
    };
    EXPECT_EQ("", with_drag(0.6, 0.0625));
    EXPECT_EQ("/effects/linear_drag/k", with_drag(0.01, 0.0625));
    EXPECT_EQ("/effects", with_drag(0, 0.0625));
    EXPECT_EQ("/effects/linear_drag/stop_speed", with_drag(0.6, 0));
    EXPECT_EQ("/effects/linear_drag/stop_speed", with_drag(0.6, 100));
}

TEST(GameSettings, WhatNoSceneMayHaveIsRefused) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {-0.1, 1e9, kNan, std::numeric_limits<double>::infinity()}) {
        Effects effects = pool_effects();
        effects.sliding->mu = bad;
        EXPECT_EQ("/effects/sliding/mu", blamed(effects)) << bad;
        effects = pool_effects();
        effects.rail.mu = bad;
        EXPECT_EQ("/effects/rail/mu", blamed(effects)) << bad;
        EXPECT_EQ("/solver/hz", blamed({{}, SolverSpec{SolverKind::kEuler, bad}})) << bad;
    }
    EXPECT_EQ("/solver/hz", blamed({{}, SolverSpec{SolverKind::kEuler, 1001}}));
    EXPECT_EQ("", blamed({{}, SolverSpec{SolverKind::kEvent, 1001}})) << "it has no ticks";
    Effects both = pool_effects();
    both.linear_drag = LinearDragSpec{};
    EXPECT_EQ("/solver/kind", blamed({both, kEvent})) << "no closed form";
    EXPECT_EQ("", blamed({both, SolverSpec{SolverKind::kEuler, 30}}));
}

TEST(GameSettings, ShotsOfRealPoolComeToRestWithEverySolver) {
    testing::Random random(71);
    for (const SolverSpec& solver : test::kPlayableSolvers) {
        const GameState start = new_game(kRules, Seat{0}, test::pool_settings(solver));
        for (int shot = 0; shot < 100; ++shot) {
            const test::PlayedShot outcome = test::shoot(kRules, start, random.direction());
            EXPECT_EQ(Outcome::kRest, outcome.trace.outcome);
            EXPECT_EQ(kPlayoutHz, outcome.trace.sample_hz);
            // Shown for as long as it takes, to the tick.
            const auto last = static_cast<double>(outcome.trace.sample_count() - 1);
            EXPECT_GE(last / kPlayoutHz, outcome.trace.duration);
            EXPECT_LT((last - 1) / kPlayoutHz, outcome.trace.duration);
        }
    }
}

}  // namespace
}  // namespace poolhall
