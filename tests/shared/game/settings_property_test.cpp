#include "shared/game/end_game.hpp"
#include "shared/game/settings.hpp"
#include "shared/physics/check.hpp"
#include "tests/shared/game/played_shot.hpp"
#include "tests/shared/random.hpp"

#include <array>
#include <gtest/gtest.h>
#include <vector>

namespace poolhall {
namespace {

const Ruleset& kRules = kEndGameRules;

/// Coefficients from the least to the largest that pass the check, and models that go with them.
GameSettings extreme_settings(testing::Random& random) {
    const auto any_of = [&](std::vector<double> choices) {
        return choices[random.below(choices.size())];
    };
    GameSettings settings;
    Effects& effects = settings.effects.emplace();
    effects.sliding = SlidingSpec{any_of({0, kLeastGameFriction, 0.2, 10})};
    effects.rolling = RollingSpec{any_of({kLeastGameFriction, 0.01, 10})};
    effects.spin_decay = SpinDecaySpec{any_of({0, kLeastGameFriction, 10})};
    effects.ball_ball.model = static_cast<BallBallModel>(random.below(4));
    effects.ball_ball.e = any_of({0, 0.5, 1});
    effects.ball_ball.mu = any_of({0, 0.05, 10});
    effects.ball_ball.min_separation = any_of({0, 1e-4, 1});
    effects.rail.model = static_cast<RailModel>(random.below(5));
    effects.rail.e = any_of({0, 0.85, 1});
    effects.rail.mu = any_of({0, 0.2, 10});
    effects.rail.nose_height = any_of({1e-3, 0.036576, 0.0571});
    if (random.below(2) == 0) effects.airborne = AirborneSpec{any_of({0, 0.5, 1})};
    constexpr std::array kKinds{SolverKind::kEuler, SolverKind::kSemiImplicit,
                                SolverKind::kExactArc, SolverKind::kEvent};
    settings.solver = SolverSpec{kKinds[random.below(4)], any_of({1, 7.5, 30, 1000})};
    return settings;
}

/// Plays random shots until the game is over or long enough; every state passes its check.
void play(const GameSettings& settings, std::uint32_t shots, testing::Random& random) {
    GameState state = new_game(kRules, Seat{0}, settings);
    while (!state.over && state.shots < shots) {
        state = test::shoot(kRules, state, random.direction()).state;
        const auto error = check(state.scene);
        ASSERT_FALSE(error) << error->pointer << " " << error->reason;
        for (const SceneBall& ball : state.scene.balls) {
            EXPECT_EQ(Vec3{}, ball.state.v);
            EXPECT_EQ(Vec3{}, ball.state.w);
        }
    }
}

TEST(GameSettings, WhateverPassesTheCheckLeavesStatesThatPassTheirs) {
    testing::Random random(72);
    for (int match = 0; match < 300; ++match) {
        const GameSettings settings = extreme_settings(random);
        ASSERT_FALSE(check(kRules, settings));
        ASSERT_NO_FATAL_FAILURE(play(settings, 4, random)) << "match " << match;
    }
}

}  // namespace
}  // namespace poolhall
