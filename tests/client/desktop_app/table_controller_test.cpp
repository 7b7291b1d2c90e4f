#include "client/desktop/app/table_controller.hpp"

#include "client/play/local_match.hpp"
#include "tests/client/play/fixtures.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace poolhall::client {
namespace {

/// The practice game, played by keys.
class PracticeTest : public ::testing::Test {
  protected:
    void press(SDL_Keycode key) {
        if (const auto action = input_.key_down(key, false)) controller_.act(*action);
        input_.key_up(key);
    }

    void hold(SDL_Keycode key, double seconds) {
        input_.key_down(key, false);
        run(seconds);
        input_.key_up(key);
    }

    void run(double seconds) {
        const auto frames = static_cast<int>(std::lround(seconds * 60));
        for (int frame = 0; frame < frames; ++frame) {
            now_ += 1.0 / 60;
            controller_.update(1.0 / 60, now_, input_.take_steering());
        }
    }

    void aim(Vec2 direction) { match_.aim(direction); }

    [[nodiscard]] Vec2 ball(std::size_t i) const { return controller_.view().balls.at(i).r; }

    [[nodiscard]] double aim_angle() const {
        const Vec2 direction = controller_.view().aim->direction;
        return std::atan2(direction.y, direction.x);
    }

    Playback playback_{Pacing::kSteady};
    LocalMatch match_{practice_spec(kEndGameRules), {"Anna", "The house"}, playback_};
    TableController controller_{match_, playback_};
    Input input_;
    double now_ = 10;
};

TEST_F(PracticeTest, BeginsAsTheOriginalDoes) {
    run(0.1);
    const ViewState view = controller_.view();
    ASSERT_EQ(view.balls.size(), 2U);
    EXPECT_EQ(view.balls[0].r, (Vec2{end_game::kBaseLineX, 0}));
    EXPECT_EQ(view.balls[1].r, (Vec2{end_game::kFootSpotX, 0}));
    ASSERT_TRUE(view.aim);
    EXPECT_TRUE(view.aim->prediction.ghost_ball);
    ASSERT_TRUE(view.placement);
    EXPECT_EQ(view.placement->low.x, end_game::kBaseLineX);
    EXPECT_EQ(view.placement->high.x, end_game::kBaseLineX);
    EXPECT_EQ(view.match.link, Link::kOffline);
    EXPECT_NE(view.hint.find("Space"), std::string::npos);
}

TEST_F(PracticeTest, UpAndDownMoveTheCueBallAndTheAimFollows) {
    hold(SDLK_UP, 0.5);
    EXPECT_NEAR(ball(0).y, 60 * end_game::kPixel, 1e-9);
    EXPECT_EQ(ball(0).x, end_game::kBaseLineX);
    EXPECT_NEAR(cross(controller_.view().aim->direction, ball(1) - ball(0)), 0, 1e-12);
    hold(SDLK_DOWN, 0.5);
    EXPECT_NEAR(ball(0).y, 0, 1e-9);
}

TEST_F(PracticeTest, CueBallStopsAtTheRails) {
    hold(SDLK_UP, 10);
    EXPECT_DOUBLE_EQ(ball(0).y, end_game::kWidth / 2 - 0.028575);
    hold(SDLK_DOWN, 20);
    EXPECT_DOUBLE_EQ(ball(0).y, -(end_game::kWidth / 2 - 0.028575));
}

TEST_F(PracticeTest, TurningRatesAreTheOriginals) {
    hold(SDLK_LEFT, 1);
    EXPECT_NEAR(aim_angle(), 0.1, 1e-9);
    hold(SDLK_RIGHT, 2);
    EXPECT_NEAR(aim_angle(), -0.1, 1e-9);
    hold(SDLK_PAGEUP, 1);
    EXPECT_NEAR(aim_angle(), 0.9, 1e-9);
    hold(SDLK_PAGEDOWN, 2);
    EXPECT_NEAR(aim_angle(), -1.1, 1e-9);
}

TEST_F(PracticeTest, TapTurnsTheAimALittle) {
    press(SDLK_PAGEUP);
    run(0.1);
    EXPECT_NEAR(aim_angle(), 1.0 / 60, 1e-9);
}

TEST_F(PracticeTest, SpaceFiresAndTheAimIsHiddenWhileBallsMove) {
    press(SDLK_SPACE);
    run(0.2);
    EXPECT_GT(ball(0).x, end_game::kBaseLineX + 0.2);
    EXPECT_FALSE(controller_.view().aim);
    EXPECT_TRUE(controller_.animated());
    run(12);
    ASSERT_TRUE(controller_.view().aim);
    EXPECT_FALSE(controller_.animated());
    EXPECT_NEAR(cross(normalized(controller_.view().aim->direction), normalized(ball(1) - ball(0))),
                0, 1e-12);
}

TEST_F(PracticeTest, CueBallStaysWhereItIsAfterTheFirstShot) {
    aim({0, 1});
    press(SDLK_SPACE);
    run(12);
    const Vec2 before = ball(0);
    hold(SDLK_UP, 0.5);
    EXPECT_EQ(ball(0), before);
    EXPECT_FALSE(controller_.view().placement);
}

TEST_F(PracticeTest, ShotOnTheScreenIsTheSimulatedOne) {
    aim({1, 0.03});
    const ShotTrace trace = turn_of(match_.info().table->state, {1, 0.03}).shot->trace;
    press(SDLK_F3);
    press(SDLK_SPACE);
    for (std::size_t k = 1; k < trace.sample_count() - 1; ++k) {
        press(SDLK_SPACE);
        for (std::size_t i = 0; i < 2; ++i) {
            EXPECT_NEAR(norm(ball(i) - xy(trace.sample(k, i))), 0, 1e-9)
                << "step " << k << " ball " << i;
        }
    }
    press(SDLK_SPACE);
    EXPECT_TRUE(playback_.idle());
}

TEST_F(PracticeTest, StepModeHoldsTimeAndLeavesARingPerMovingBall) {
    press(SDLK_F3);
    EXPECT_TRUE(controller_.view().step_mode);
    press(SDLK_SPACE);
    run(2);
    EXPECT_EQ(ball(0).x, end_game::kBaseLineX);
    press(SDLK_SPACE);
    press(SDLK_SPACE);
    EXPECT_NEAR(ball(0).x, end_game::kBaseLineX + end_game::kShotSpeed * (2 - 0.02) / 30, 1e-9);
    const auto trail = controller_.view().trail;
    ASSERT_EQ(trail.size(), 2U);
    EXPECT_EQ(trail[0].r.x, end_game::kBaseLineX);
    EXPECT_LT(trail[0].strength, trail[1].strength);
    run(2);
    EXPECT_EQ(controller_.view().trail.size(), 2U);
}

/// Steps to the end of a shot, and looks at it.
class EndOfSteps : public PracticeTest {
  protected:
    void SetUp() override {
        press(SDLK_F3);
        shoot_and_step({0, 1});
    }

    void shoot_and_step(Vec2 direction) {
        aim(direction);
        press(SDLK_SPACE);
        ASSERT_FALSE(playback_.idle());
        while (!playback_.idle())
            press(SDLK_SPACE);
        run(0.05);
    }

    [[nodiscard]] std::uint32_t shots() const { return match_.info().table->shot; }
};

TEST_F(EndOfSteps, SpaceThatGoesOnBeingPressedNeverShoots) {
    const std::uint32_t before = shots();
    for (int i = 0; i < 200; ++i) {
        press(SDLK_SPACE);
        run(0.2);
    }
    EXPECT_EQ(shots(), before);
    EXPECT_TRUE(playback_.idle());
}

TEST_F(EndOfSteps, SpaceGoesBackToTheTableAndThenShoots) {
    EXPECT_NE(controller_.view().hint.find("End of the shot"), std::string::npos);
    EXPECT_FALSE(controller_.view().aim);
    run(1);
    EXPECT_FALSE(controller_.view().aim) << "it stays until it is left";
    press(SDLK_SPACE);
    EXPECT_TRUE(playback_.idle());
    EXPECT_TRUE(controller_.view().aim);
    EXPECT_NE(controller_.view().hint.find("Space shoots"), std::string::npos);
    run(1);
    press(SDLK_SPACE);
    EXPECT_FALSE(playback_.idle());
}

TEST_F(EndOfSteps, NeitherKeysNorMouseTouchTheNextShot) {
    run(1);
    const Vec2 aimed = match_.info().table->aim;
    hold(SDLK_LEFT, 0.5);
    controller_.pointer_moved({0.1, 0.1});
    controller_.pointer_pressed({0.1, 0.1});
    EXPECT_EQ(match_.info().table->aim, aimed);
    EXPECT_TRUE(playback_.idle());
    EXPECT_TRUE(controller_.view().aim) << "the click goes back to the table";
}

TEST_F(EndOfSteps, LeavingStepModeLeavesItToo) {
    press(SDLK_F3);
    EXPECT_TRUE(controller_.view().aim);
    press(SDLK_SPACE);
    EXPECT_FALSE(playback_.idle());
}

TEST_F(PracticeTest, SpaceAfterTheLastStepOfAGameStartsNoShotOfTheNext) {
    press(SDLK_F3);
    aim(direction_with(Verdict::kScratch));
    press(SDLK_SPACE);
    run(0.1);
    while (!playback_.idle())
        press(SDLK_SPACE);
    ASSERT_TRUE(controller_.view().banner);
    for (int i = 0; i < 10; ++i) {
        press(SDLK_SPACE);
        run(0.2);
    }
    EXPECT_TRUE(controller_.view().banner) << "nobody had the time to read it";
    run(1);
    press(SDLK_SPACE);
    run(0.1);
    EXPECT_FALSE(controller_.view().banner);
    for (int i = 0; i < 10; ++i) {
        press(SDLK_SPACE);
        run(0.2);
    }
    EXPECT_TRUE(playback_.idle());
    run(1);
    press(SDLK_SPACE);
    EXPECT_FALSE(playback_.idle());
}

TEST_F(PracticeTest, LeavingStepModeGoesOnAtNormalSpeed) {
    press(SDLK_F3);
    press(SDLK_SPACE);
    press(SDLK_SPACE);
    press(SDLK_F3);
    const double before = ball(0).x;
    run(0.1);
    EXPECT_NEAR(ball(0).x - before, end_game::kShotSpeed * 0.1, 0.03);
    EXPECT_TRUE(controller_.view().trail.empty());
}

TEST_F(PracticeTest, CollisionModeMarksEveryTimeOfImpact) {
    press(SDLK_SPACE);
    run(12);
    EXPECT_TRUE(controller_.view().marks.empty());
    press(SDLK_F4);
    EXPECT_TRUE(controller_.view().collision_mode);
    std::size_t expected = 0;
    const auto game = kEndGameRules.new_game(Seat{0});
    const Turn turn = turn_of(game, kEndGameRules.legal(game).aim);
    for (const ShotEvent& event : turn.shot->trace.events) {
        if (event.kind == EventKind::kBallBall) expected += 2;
        if (event.kind == EventKind::kBallRail) expected += 1;
    }
    EXPECT_GE(expected, 3U);
    EXPECT_EQ(controller_.view().marks.size(), expected);
    press(SDLK_F3);
    press(SDLK_SPACE);
    run(0.1);
    EXPECT_TRUE(controller_.view().marks.empty());
    EXPECT_TRUE(controller_.view().step_mode && controller_.view().collision_mode);
}

TEST_F(PracticeTest, ScratchLosesAtOnceAndANewGameComesAfterThreeSeconds) {
    aim(direction_with(Verdict::kScratch));
    press(SDLK_SPACE);
    while (!controller_.view().banner && now_ < 40)
        run(1.0 / 60);
    ASSERT_TRUE(controller_.view().banner);
    EXPECT_EQ(controller_.view().banner->title, "You lose");
    EXPECT_EQ(controller_.view().banner->tone, Tone::kLost);
    EXPECT_TRUE(controller_.view().balls[0].sunk);
    run(2.5);
    EXPECT_TRUE(controller_.view().banner);
    run(0.7);
    EXPECT_FALSE(controller_.view().banner);
    EXPECT_EQ(ball(0), (Vec2{end_game::kBaseLineX, 0}));
    EXPECT_EQ(controller_.view().match.seats[1].wins, 1U);
}

TEST_F(PracticeTest, SpaceStartsTheNewGameAtOnce) {
    aim(direction_with(Verdict::kScratch));
    press(SDLK_SPACE);
    while (!controller_.view().banner && now_ < 40)
        run(1.0 / 60);
    press(SDLK_SPACE);
    run(0.1);
    EXPECT_FALSE(controller_.view().banner);
    EXPECT_TRUE(controller_.view().aim);
}

TEST_F(PracticeTest, WinIsCountedOnceEverythingRests) {
    aim(direction_with(Verdict::kWon));
    press(SDLK_SPACE);
    run(0.2);
    EXPECT_EQ(controller_.view().match.seats[0].wins, 0U);
    while (!playback_.idle()) {
        EXPECT_FALSE(controller_.view().banner);
        run(1.0 / 60);
    }
    ASSERT_TRUE(controller_.view().banner);
    EXPECT_EQ(controller_.view().banner->title, "You win");
    EXPECT_EQ(controller_.view().match.seats[0].wins, 1U);
    EXPECT_TRUE(controller_.view().balls[1].sunk);
    int announced = 0;
    for (const TableSound& sound : controller_.take_sounds())
        announced += std::holds_alternative<GameEnded>(sound) ? 1 : 0;
    EXPECT_EQ(announced, 1);
}

TEST_F(PracticeTest, MouseAimsShootsAndDragsTheCueBall) {
    controller_.pointer_moved({end_game::kBaseLineX, 0.2});
    EXPECT_NEAR(aim_angle(), std::acos(0.0), 1e-12);
    controller_.pointer_pressed(ball(0));
    controller_.pointer_moved({0.3, 0.15});
    EXPECT_EQ(ball(0), (Vec2{end_game::kBaseLineX, 0.15}));
    controller_.pointer_released();
    controller_.pointer_moved({0.3, 0.15});
    EXPECT_NEAR(aim_angle(), 0, 1e-12);
    controller_.pointer_pressed({0.3, 0.15});
    run(0.1);
    EXPECT_FALSE(playback_.idle());
}

TEST_F(PracticeTest, StatusLineGoesAway) {
    press(SDLK_h);
    run(0.1);
    EXPECT_FALSE(controller_.view().status.empty());
    run(TableController::kStatusTime);
    EXPECT_TRUE(controller_.view().status.empty());
}

}  // namespace
}  // namespace poolhall::client
