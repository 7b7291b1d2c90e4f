#include "client/desktop/app/solver_overlay.hpp"

#include "client/desktop/app/table_controller.hpp"
#include "client/play/local_match.hpp"
#include "client/play/remote_match.hpp"
#include "protocol/limits.hpp"
#include "shared/physics/simulate.hpp"
#include "tests/client/play/fixtures.hpp"

#include <chrono>
#include <cmath>
#include <gtest/gtest.h>
#include <thread>

namespace poolhall::client {
namespace {

/// A straight first shot of the end game.
Shot first_shot(std::uint32_t number = 1) {
    const GameState game = kEndGameRules.new_game(Seat{0});
    const SimulatedShot shot = *turn_of(game, kStraight).shot;
    return {number, shot.scene, game.cue_ball, ShotTimeline(positions_of(shot.scene)), {}};
}

/// Waits for what is being computed.
void finish(SolverOverlay& overlay) {
    for (int i = 0; overlay.pending() && i < 2000; ++i) {
        if (!overlay.poll()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    ASSERT_FALSE(overlay.pending());
}

TEST(SolverOverlay, IsOffUntilItIsAskedFor) {
    SolverOverlay overlay;
    overlay.follow(first_shot());
    EXPECT_FALSE(overlay.pending());
    EXPECT_TRUE(overlay.view(0).empty());
    EXPECT_EQ(overlay.description(), "Other solvers: off");
}

TEST(SolverOverlay, CyclesThroughItsSetsOfSolversAndOffAgain) {
    SolverOverlay overlay;
    overlay.follow(first_shot());
    overlay.cycle();
    EXPECT_EQ(overlay.description(), "Other solvers: event, euler 30 Hz, overlap 30 Hz");
    finish(overlay);
    const std::vector<std::vector<std::string>> sets{
        {"event", "euler 30 Hz", "overlap 30 Hz"},
        {"euler 30 Hz", "euler 120 Hz", "euler 480 Hz"},
        {"event", "semi_implicit 30 Hz", "exact_arc 30 Hz"},
        {}};
    for (const auto& set : sets) {
        const auto views = overlay.view(0);
        ASSERT_EQ(views.size(), set.size());
        for (std::size_t i = 0; i < set.size(); ++i)
            EXPECT_EQ(views[i].name, set[i]);
        overlay.cycle();
        EXPECT_FALSE(overlay.pending()) << "all that it shows of a shot is computed at once";
    }
}

TEST(SolverOverlay, EachSolversBallsEndWhereItSaysSo) {
    const Shot shot = first_shot();
    SolverOverlay overlay;
    overlay.cycle();
    overlay.follow(shot);
    finish(overlay);
    const auto views = overlay.view(1e9);
    ASSERT_EQ(views.size(), 3U);
    const SolverSpec solvers[] = {
        {SolverKind::kEvent}, {SolverKind::kEuler, 30}, {SolverKind::kOverlap, 30}};
    for (std::size_t i = 0; i < 3; ++i) {
        Scene scene = shot.scene;
        scene.solver = solvers[i];
        const ShotTrace trace = simulate(scene);
        ASSERT_EQ(views[i].balls.size(), 2U);
        EXPECT_EQ(views[i].balls[0], xy(trace.balls[0].state.r));
        EXPECT_EQ(views[i].paths[1].back(), xy(trace.balls[1].state.r));
        EXPECT_EQ(views[i].decides, solvers[i] == shot.scene.solver);
        EXPECT_TRUE(views[i].cost.ends_with(" \xC2\xB5s")) << views[i].cost;
    }
    EXPECT_EQ(views[0].distance, "the reference");
    EXPECT_NE(views[1].distance.find("mm off event"), std::string::npos) << views[1].distance;
}

TEST(SolverOverlay, BeforeTheFirstShotItWaitsForOne) {
    SolverOverlay overlay;
    overlay.cycle();
    EXPECT_TRUE(overlay.description().ends_with("; from the next shot on"));
    EXPECT_TRUE(overlay.view(0).empty());
    overlay.follow(first_shot());
    finish(overlay);
    EXPECT_EQ(overlay.view(0).size(), 3U);
}

TEST(SolverOverlay, AShotWhoseStrikeIsNotKnownHasNone) {
    Shot shot = first_shot();
    shot.scene.strike.reset();  // as for who joins while it runs
    SolverOverlay overlay;
    overlay.follow(shot);
    overlay.cycle();
    EXPECT_FALSE(overlay.pending());
    EXPECT_TRUE(overlay.view(0).empty());
    EXPECT_TRUE(overlay.description().ends_with("; from the next shot on"));
}

TEST(SolverOverlay, TheNextShotTakesThePlaceOfTheLast) {
    SolverOverlay overlay;
    overlay.cycle();
    overlay.follow(first_shot(1));
    overlay.follow(first_shot(2));  // while the first is still being computed
    EXPECT_TRUE(overlay.view(0).empty());
    finish(overlay);
    EXPECT_EQ(overlay.view(0).size(), 3U);
    EXPECT_EQ(overlay.shot(), 2U);
}

TEST(SolverOverlay, ASolverThatCannotDoTheEffectsSaysSo) {
    Shot shot = first_shot();
    shot.scene.effects.airborne = AirborneSpec{};
    SolverOverlay overlay;
    overlay.cycle();
    overlay.follow(shot);
    finish(overlay);
    const auto views = overlay.view(0);
    EXPECT_EQ(views[2].distance, "cannot do these effects");
    EXPECT_TRUE(views[2].paths.empty());
    EXPECT_FALSE(views[1].paths.empty());
}

/// The overlay at the table, by F5.
class SolversAtTheTable : public ::testing::Test {
  protected:
    static void run(TableController& controller, double seconds) {
        for (double passed = 0; passed < seconds; passed += 1.0 / 60) {
            clock_s += 1.0 / 60;
            controller.update(1.0 / 60, clock_s, {});
        }
    }

    /// Time of the table stands still meanwhile.
    static void wait(TableController& controller) {
        for (int i = 0; controller.view().solvers.empty() && i < 2000; ++i) {
            controller.update(0, clock_s, {});
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
    }

    static double clock_s;
};

double SolversAtTheTable::clock_s = 10;

TEST_F(SolversAtTheTable, InPracticeTheGamesOwnSolverGoesAsThePlayedBalls) {
    Playback playback{Pacing::kSteady};
    LocalMatch match{practice_spec(kEndGameRules), {"Anna", "The house"}, playback};
    TableController controller{match, playback};
    controller.act(Action::kSolvers);
    EXPECT_TRUE(controller.view().solvers.empty());
    EXPECT_TRUE(controller.view().status.starts_with("Other solvers: event"));
    controller.act(Action::kGo);
    run(controller, 0.5);
    wait(controller);
    const ViewState view = controller.view();
    ASSERT_EQ(view.solvers.size(), 3U);
    EXPECT_TRUE(view.solvers[1].decides);
    for (std::size_t ball = 0; ball < 2; ++ball)
        EXPECT_NEAR(norm(view.solvers[1].balls[ball] - view.balls[ball].r), 0, 1e-3);
}

TEST_F(SolversAtTheTable, StepModeMovesTheirBallsStepByStep) {
    Playback playback{Pacing::kSteady};
    LocalMatch match{practice_spec(kEndGameRules), {"Anna", "The house"}, playback};
    TableController controller{match, playback};
    controller.act(Action::kStepMode);
    controller.act(Action::kSolvers);
    controller.act(Action::kGo);
    run(controller, 0.1);
    wait(controller);
    Vec2 last = controller.view().solvers.at(0).balls.at(0);
    EXPECT_EQ(last, controller.view().balls[0].r);
    for (int step = 0; step < 5; ++step) {
        controller.act(Action::kGo);
        const Vec2 now = controller.view().solvers.at(0).balls.at(0);
        EXPECT_GT(now.x, last.x + 0.05);
        last = now;
        run(controller, 0.2);
        EXPECT_EQ(controller.view().solvers.at(0).balls.at(0), now) << "time did not stand still";
    }
}

TEST_F(SolversAtTheTable, OverTheNetworkTheSceneOfTheShotIsEnough) {
    TokensInMemory tokens;
    ScriptedTransport transport;
    Playback playback{Pacing::kLive};
    RemoteMatch match{{"h:1", "", "Anna", false}, transport, tokens, playback};
    TableController controller{match, playback};
    transport.events.emplace_back(Opened{});
    transport.say(protocol::Welcome{"poolhall 0.1.0", protocol::kVersion});
    transport.say(protocol::Joined{1, "", {}, new_table()});
    run(controller, 0.1);
    for (const auto& message : messages_of_shot(new_table(), kStraight))
        transport.say(message);
    run(controller, 30);
    ASSERT_TRUE(playback.idle());
    controller.act(Action::kSolvers);  // after the shot: it is the last one
    wait(controller);
    const ViewState view = controller.view();
    ASSERT_EQ(view.solvers.size(), 3U);
    for (std::size_t ball = 0; ball < 2; ++ball)
        EXPECT_NEAR(norm(view.solvers[1].balls[ball] - view.balls[ball].r), 0, 1e-9);
}

}  // namespace
}  // namespace poolhall::client
