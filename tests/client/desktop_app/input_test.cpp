#include "client/desktop/app/input.hpp"

#include "shared/game/end_game.hpp"

#include <gtest/gtest.h>
#include <utility>

namespace poolhall::client {
namespace {

TEST(Input, EveryKeyOfTheTableHasItsAction) {
    const std::pair<SDL_Keycode, Action> keys[] = {
        {SDLK_ESCAPE, Action::kExit},      {SDLK_F1, Action::kHelp},
        {SDLK_F2, Action::kFrameRate},     {SDLK_F3, Action::kStepMode},
        {SDLK_F4, Action::kCollisionMode}, {SDLK_F5, Action::kSolvers},
        {SDLK_SPACE, Action::kGo},         {SDLK_p, Action::kScreenshot},
        {SDLK_m, Action::kMute},           {SDLK_h, Action::kHotSeat},
        {SDLK_c, Action::kCopyCode}};
    Input input;
    for (const auto& [key, action] : keys)
        EXPECT_EQ(input.key_down(key, false), action) << key;
    EXPECT_EQ(input.key_down(SDLK_q, false), std::nullopt);
}

TEST(Input, KeyHeldDownActsOnce) {
    Input input;
    EXPECT_TRUE(input.key_down(SDLK_SPACE, false));
    EXPECT_FALSE(input.key_down(SDLK_SPACE, true));
}

TEST(Input, HeldKeysSteerUntilTheyComeUp) {
    Input input;
    EXPECT_FALSE(input.steers());
    input.key_down(SDLK_LEFT, false);
    input.key_down(SDLK_UP, false);
    for (int frame = 0; frame < 3; ++frame) {
        const Steering steering = input.take_steering();
        EXPECT_EQ(steering.turn, 0.1);
        EXPECT_EQ(steering.slide, 120 * end_game::kPixel);
    }
    input.key_up(SDLK_LEFT);
    input.key_up(SDLK_UP);
    EXPECT_TRUE(input.take_steering().idle());
}

TEST(Input, OppositeKeysCancel) {
    Input input;
    input.key_down(SDLK_PAGEUP, false);
    input.key_down(SDLK_PAGEDOWN, false);
    EXPECT_EQ(input.take_steering().turn, 0);
}

TEST(Input, TapBetweenTwoFramesCountsForOne) {
    Input input;
    input.key_down(SDLK_RIGHT, false);
    input.key_up(SDLK_RIGHT);
    EXPECT_TRUE(input.steers());
    EXPECT_EQ(input.take_steering().turn, -0.1);
    EXPECT_EQ(input.take_steering().turn, 0);
}

TEST(Input, LostFocusReleasesAll) {
    Input input;
    input.key_down(SDLK_DOWN, false);
    input.release_all();
    EXPECT_TRUE(input.take_steering().idle());
}

}  // namespace
}  // namespace poolhall::client
