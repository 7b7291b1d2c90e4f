#include "client/desktop/app/input.hpp"

#include "shared/game/end_game.hpp"

#include <gtest/gtest.h>
#include <utility>

namespace poolhall::client {
namespace {

TEST(Input, EveryKeyOfTheTableHasItsAction) {
    const std::pair<SDL_Keycode, Action> keys[] = {
        {SDLK_ESCAPE, Action::kExit},  {SDLK_F2, Action::kFrameRate},
        {SDLK_F3, Action::kStepMode},  {SDLK_F4, Action::kCollisionMode},
        {SDLK_F5, Action::kSolvers},   {SDLK_SPACE, Action::kGo},
        {SDLK_p, Action::kScreenshot}, {SDLK_m, Action::kMute},
        {SDLK_h, Action::kHotSeat},    {SDLK_c, Action::kCopyCode}};
    Input input;
    for (const auto& [key, action] : keys)
        EXPECT_EQ(input.key_down(key, false), action) << key;
    EXPECT_EQ(input.key_down(SDLK_q, false), std::nullopt);
}

SDL_Keysym key(SDL_Scancode place, SDL_Keycode letter) {
    SDL_Keysym result{};
    result.scancode = place;
    result.sym = letter;
    return result;
}

bool has_latin_letters(SDL_Keycode) {
    return true;
}

bool has_none(SDL_Keycode) {
    return false;
}

TEST(Meant, LetterCountsWhereverItStands) {
    EXPECT_EQ(meant(key(SDL_SCANCODE_H, SDLK_h), has_latin_letters), SDLK_h);
    EXPECT_EQ(meant(key(SDL_SCANCODE_SEMICOLON, SDLK_m), has_latin_letters), SDLK_m) << "AZERTY";
    EXPECT_EQ(meant(key(SDL_SCANCODE_M, SDLK_COMMA), has_latin_letters), SDLK_COMMA) << "AZERTY";
    EXPECT_EQ(meant(key(SDL_SCANCODE_I, SDLK_c), has_latin_letters), SDLK_c) << "Dvorak";
    EXPECT_EQ(meant(key(SDL_SCANCODE_C, SDLK_j), has_latin_letters), SDLK_j) << "Dvorak";
    EXPECT_EQ(meant(key(SDL_SCANCODE_P, 0xF6), has_latin_letters), 0xF6) << "its P is elsewhere";
}

TEST(Meant, PlaceCountsWhereTheLayoutHasNoSuchLetter) {
    const SDL_Keycode russian_r = 0x440;
    const SDL_Keycode greek_psi = 0x3C8;
    const SDL_Keycode arabic_alef_maksura = 0x649;
    const SDL_Keycode hebrew_pe = 0x5E4;
    EXPECT_EQ(meant(key(SDL_SCANCODE_H, russian_r), has_none), SDLK_h);
    EXPECT_EQ(meant(key(SDL_SCANCODE_C, greek_psi), has_none), SDLK_c);
    EXPECT_EQ(meant(key(SDL_SCANCODE_M, arabic_alef_maksura), has_none), SDLK_m);
    EXPECT_EQ(meant(key(SDL_SCANCODE_P, hebrew_pe), has_none), SDLK_p);
    EXPECT_EQ(meant(key(SDL_SCANCODE_W, SDLK_QUOTE), has_none), SDLK_w) << "Hebrew";
}

TEST(Meant, KeysThatAreNoLettersStayWhatTheyAre) {
    EXPECT_EQ(meant(key(SDL_SCANCODE_F1, SDLK_F1), has_none), SDLK_F1);
    EXPECT_EQ(meant(key(SDL_SCANCODE_SPACE, SDLK_SPACE), has_none), SDLK_SPACE);
    EXPECT_EQ(meant(key(SDL_SCANCODE_COMMA, 0x431), has_none), 0x431);
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
