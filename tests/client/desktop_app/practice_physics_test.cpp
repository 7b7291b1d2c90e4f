#include "client/desktop/app/physics_file.hpp"
#include "client/desktop/app/table_controller.hpp"
#include "client/play/local_match.hpp"
#include "shared/game/end_game.hpp"
#include "shared/physics/simulate.hpp"
#include "tests/client/play/fixtures.hpp"
#include "tests/shared/game/pool_settings.hpp"

#include <gtest/gtest.h>
#include <iostream>
#include <sstream>

namespace poolhall::client {
namespace {

/// Practice with physics of the player's choice.
struct Practice {
    explicit Practice(GameSettings chosen)
        : settings(std::move(chosen)),
          match(practice_spec(kEndGameRules, settings), {"Anna", "The house"}, playback) {}

    void shoot_to_the_end(Vec2 direction) {
        match.make(Shoot{{.direction = direction}});
        for (int frame = 0; !playback.idle() && frame < 6000; ++frame)
            pass(1.0 / 60);
    }

    void pass(double seconds) { controller.update(seconds, now += seconds, {}); }

    GameSettings settings;
    Playback playback{Pacing::kSteady};
    LocalMatch match;
    TableController controller{match, playback};
    double now = 10;
};

/// A shot that sinks nothing: else the next game would begin by itself.
Turn passing_shot(const GameState& state) {
    double y = 0.1;
    Turn turn = turn_of(state, {-1, y});
    while (turn.state.over)
        turn = turn_of(state, {-1, y += 0.1});
    return turn;
}

TEST(PracticePhysics, ShotsAreThoseOfTheChosenSolver) {
    for (const SolverSpec& solver : test::kPlayableSolvers) {
        Practice practice(test::pool_settings(solver));
        const GameState state = new_game(kEndGameRules, Seat{0}, practice.settings);
        EXPECT_EQ(practice.match.info().table->state.scene, state.scene);
        const Turn turn = passing_shot(state);
        practice.shoot_to_the_end(turn.shot->scene.strike->direction);
        EXPECT_TRUE(practice.playback.idle());
        EXPECT_EQ(practice.match.info().table->state.scene, turn.state.scene);
        EXPECT_EQ(practice.match.info().kernel, turn.shot->trace.kernel);
    }
}

TEST(PracticePhysics, FileMayBeStandardInput) {
    std::istringstream text("{}");
    std::streambuf* const input = std::cin.rdbuf(text.rdbuf());
    const auto settings = read_physics("-", kEndGameRules);
    std::cin.rdbuf(input);
    ASSERT_FALSE(settings.ok());
    EXPECT_TRUE(settings.error().starts_with("standard input: ")) << settings.error();
}

TEST(PracticePhysics, AreKeptForTheNextGame) {
    Practice practice(test::pool_settings());
    const Vec2 corner{-end_game::kLength / 2 - end_game::kBaseLineX, end_game::kWidth / 2};
    practice.shoot_to_the_end(corner);
    ASSERT_EQ(practice.match.info().table->phase, protocol::Phase::kOver);
    practice.match.make(Agree{});
    EXPECT_EQ(practice.match.info().table->game_number, 2U);
    EXPECT_EQ(practice.match.info().table->state.scene,
              new_game(kEndGameRules, Seat{0}, practice.settings).scene);
}

TEST(PracticePhysics, ShotThatIsOverAtOnceIsHeard) {
    Effects effects;
    effects.linear_drag = LinearDragSpec{};
    effects.rail = {RailModel::kRestitution, 0, 0.2, 0.036576};
    Practice dead({effects, SolverSpec{SolverKind::kEvent, 30}});
    dead.shoot_to_the_end({-1, 0});  // the cue ball stops dead at the rail
    const double edge = inset(dead.match.info().table->state.scene.table, BallSpec{}.radius).x;
    ASSERT_EQ(dead.match.info().table->state.scene.balls[0].state.r.x, -edge);
    (void)dead.controller.take_sounds();
    dead.shoot_to_the_end({-1, 0});
    EXPECT_TRUE(dead.playback.idle());
    EXPECT_GE(dead.controller.take_sounds().size(), 2U) << "the strike and the rail";
}

TEST(PracticePhysics, AreNamedWhereTheyAreNotTheGamesOwn) {
    Practice own({});
    own.pass(0.1);
    EXPECT_EQ(own.controller.view().physics, "");
    EXPECT_EQ(own.controller.view(60).physics, "euler 30 Hz") << "beside the frame rate";
    own.shoot_to_the_end({1, 0.3});
    EXPECT_EQ(own.controller.view(60).physics,
              "euler 30 Hz, drag_rails_pockets; called for: drag, rails, pockets");

    Practice chosen(test::pool_settings());
    chosen.pass(0.1);
    EXPECT_EQ(chosen.controller.view().physics, "event");
    chosen.shoot_to_the_end({1, 0.3});
    EXPECT_EQ(
        chosen.controller.view().physics,
        "event, slide_roll_spin_end_game; called for: sliding, rolling, spin, rails, pockets, "
        "throw (idle)");
}

}  // namespace
}  // namespace poolhall::client
