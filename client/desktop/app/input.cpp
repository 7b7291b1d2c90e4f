#include "client/desktop/app/input.hpp"

#include "shared/game/end_game.hpp"

#include <algorithm>

namespace poolhall::client {
namespace {

struct ActionKey {
    SDL_Keycode key;
    Action action;
};

constexpr auto kActionKeys = std::to_array<ActionKey>({
    {SDLK_ESCAPE, Action::kExit},
    {SDLK_F2, Action::kFrameRate},
    {SDLK_F3, Action::kStepMode},
    {SDLK_F4, Action::kCollisionMode},
    {SDLK_F5, Action::kSolvers},
    {SDLK_SPACE, Action::kGo},
    {SDLK_p, Action::kScreenshot},
    {SDLK_m, Action::kMute},
    {SDLK_h, Action::kHotSeat},
    {SDLK_c, Action::kCopyCode},
});

struct SteeringKey {
    SDL_Keycode key;
    Steering steering;
};

constexpr double kSlowTurn = 0.1;                       // rad/s
constexpr double kFastTurn = 1;                         // rad/s
constexpr double kSlideSpeed = 120 * end_game::kPixel;  // m/s

constexpr auto kSteering = std::to_array<SteeringKey>({
    {SDLK_LEFT, {kSlowTurn, 0}},
    {SDLK_RIGHT, {-kSlowTurn, 0}},
    {SDLK_PAGEUP, {kFastTurn, 0}},
    {SDLK_PAGEDOWN, {-kFastTurn, 0}},
    {SDLK_UP, {0, kSlideSpeed}},
    {SDLK_DOWN, {0, -kSlideSpeed}},
});

}  // namespace

std::optional<Action> action_of(SDL_Keycode key) {
    const auto* found = std::find_if(std::begin(kActionKeys), std::end(kActionKeys),
                                     [key](const ActionKey& k) { return k.key == key; });
    return found != std::end(kActionKeys) ? std::optional(found->action) : std::nullopt;
}

SDL_Keycode meant(const SDL_Keysym& key, LayoutHas layout_has) {
    const bool is_letter = key.sym >= SDLK_a && key.sym <= SDLK_z;
    const bool in_place_of_one = key.scancode >= SDL_SCANCODE_A && key.scancode <= SDL_SCANCODE_Z;
    if (is_letter || !in_place_of_one) return key.sym;
    const SDL_Keycode letter = SDLK_a + (key.scancode - SDL_SCANCODE_A);
    return layout_has(letter) ? key.sym : letter;
}

std::optional<Action> Input::key_down(SDL_Keycode key, bool repeat) {
    if (repeat) return std::nullopt;
    if (Key* steering = steering_key(key)) {
        *steering = {true, true};
        return std::nullopt;
    }
    return action_of(key);
}

void Input::key_up(SDL_Keycode key) {
    if (Key* steering = steering_key(key)) steering->held = false;
}

void Input::release_all() {
    keys_ = {};
}

Steering Input::take_steering() {
    static_assert(std::size(kSteering) == kSteeringKeys);
    Steering total;
    for (std::size_t i = 0; i < kSteeringKeys; ++i) {
        if (keys_[i].held || keys_[i].tapped) {
            total.turn += kSteering[i].steering.turn;
            total.slide += kSteering[i].steering.slide;
        }
        keys_[i].tapped = false;
    }
    return total;
}

bool Input::steers() const {
    return std::any_of(keys_.begin(), keys_.end(), [](const Key& k) { return k.held || k.tapped; });
}

Input::Key* Input::steering_key(SDL_Keycode key) {
    for (std::size_t i = 0; i < kSteeringKeys; ++i) {
        if (kSteering[i].key == key) return &keys_[i];
    }
    return nullptr;
}

}  // namespace poolhall::client
