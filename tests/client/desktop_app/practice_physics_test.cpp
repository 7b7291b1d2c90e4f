#include "client/desktop/app/table_controller.hpp"
#include "client/play/practice_match.hpp"
#include "shared/game/end_game.hpp"
#include "shared/physics/simulate.hpp"
#include "tests/shared/game/pool_settings.hpp"

#include <gtest/gtest.h>

namespace poolhall::client {
namespace {

/// Practice with physics of the player's choice.
struct Practice {
    explicit Practice(GameSettings chosen)
        : settings(std::move(chosen)), match(kEndGameRules, "Anna", playback, settings) {}

    void shoot_to_the_end(Vec2 direction) {
        match.shoot(direction);
        for (int frame = 0; !playback.idle() && frame < 6000; ++frame)
            pass(1.0 / 60);
    }

    void pass(double seconds) { controller.update(seconds, now += seconds, {}); }

    GameSettings settings;
    Playback playback{Pacing::kSteady};
    PracticeMatch match;
    TableController controller{match, playback};
    double now = 10;
};

/// The rules' outcome of a shot that sinks nothing: else the next game would begin by itself.
ShotOutcome passing_shot(const GameState& state) {
    double y = 0.1;
    ShotOutcome outcome = kEndGameRules.play(state, {{-1, y}});
    while (outcome.state.over)
        outcome = kEndGameRules.play(state, {{-1, y += 0.1}});
    return outcome;
}

TEST(PracticePhysics, ShotsAreThoseOfTheChosenSolver) {
    for (const SolverSpec& solver : test::kPlayableSolvers) {
        Practice practice(test::pool_settings(solver));
        const GameState state = new_game(kEndGameRules, Seat{0}, practice.settings);
        EXPECT_EQ(practice.match.info().table->scene, state.scene);
        const ShotOutcome outcome = passing_shot(state);
        practice.shoot_to_the_end(outcome.scene.strike->direction);
        EXPECT_TRUE(practice.playback.idle());
        EXPECT_EQ(practice.match.info().table->scene, outcome.state.scene);
        EXPECT_EQ(practice.match.info().kernel, outcome.trace.kernel);
    }
}

TEST(PracticePhysics, AreKeptForTheNextGame) {
    Practice practice(test::pool_settings());
    const Vec2 corner{-end_game::kLength / 2 - end_game::kBaseLineX, end_game::kWidth / 2};
    practice.shoot_to_the_end(corner);
    ASSERT_EQ(practice.match.info().table->phase, protocol::Phase::kOver);
    practice.match.ask_new_game();
    EXPECT_EQ(practice.match.info().table->game_number, 2U);
    EXPECT_EQ(practice.match.info().table->scene,
              new_game(kEndGameRules, Seat{0}, practice.settings).scene);
}

TEST(PracticePhysics, ShotThatIsOverAtOnceIsHeard) {
    Effects effects;
    effects.linear_drag = LinearDragSpec{};
    effects.rail = {RailModel::kRestitution, 0, 0.2, 0.036576};
    Practice dead({effects, SolverSpec{SolverKind::kEvent, 30}});
    dead.shoot_to_the_end({-1, 0});  // the cue ball stops dead at the rail
    const double edge = inset(dead.match.info().table->scene.table, BallSpec{}.radius).x;
    ASSERT_EQ(dead.match.info().table->scene.balls[0].state.r.x, -edge);
    (void)dead.controller.take_heard();
    dead.shoot_to_the_end({-1, 0});
    EXPECT_TRUE(dead.playback.idle());
    EXPECT_GE(dead.controller.take_heard().size(), 2U) << "the strike and the rail";
}

TEST(PracticePhysics, AreNamedWhereTheyAreNotTheGamesOwn) {
    Practice own({});
    own.pass(0.1);
    EXPECT_EQ(own.controller.view().physics, "");
    EXPECT_EQ(own.controller.view(60).physics, "euler 30 Hz") << "beside the frame rate";
    own.shoot_to_the_end({1, 0.3});
    EXPECT_EQ(own.controller.view(60).physics, "euler 30 Hz, drag_rails_pockets");

    Practice chosen(test::pool_settings());
    chosen.pass(0.1);
    EXPECT_EQ(chosen.controller.view().physics, "event");
    chosen.shoot_to_the_end({1, 0.3});
    EXPECT_EQ(chosen.controller.view().physics, "event, slide_roll_spin_end_game");
}

}  // namespace
}  // namespace poolhall::client
