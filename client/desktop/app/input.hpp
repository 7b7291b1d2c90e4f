#pragma once

#include <SDL2/SDL_keyboard.h>

#include <array>
#include <cstdint>
#include <optional>

namespace poolhall::client {

/// What a key asks for at the moment it goes down.
enum class Action : std::uint8_t {
    kExit,
    kFrameRate,
    kStepMode,
    kCollisionMode,
    kSolvers,
    kGo,  ///< fire, step, new game: whatever is next
    kScreenshot,
    kMute,
    kHotSeat,
    kCopyCode,
};

/// What the held keys ask for.
struct Steering {
    double turn = 0;   ///< of the aim, rad/s, counterclockwise
    double slide = 0;  ///< of the cue ball in hand, m/s, upwards

    [[nodiscard]] bool idle() const { return turn == 0 && slide == 0; }
};

/// What the key asks for; nothing for those that steer and those that do nothing.
[[nodiscard]] std::optional<Action> action_of(SDL_Keycode key);

/// Whether the layout in use has a key, in any place.
using LayoutHas = bool (*)(SDL_Keycode key);

/// The key that is meant: the letter that stands on it (M is where M is printed, on AZERTY too), or
/// where the layout has no such letter (Russian, Greek, Arabic, Hebrew) the one that a US keyboard
/// has in that place.
[[nodiscard]] SDL_Keycode meant(const SDL_Keysym& key, LayoutHas layout_has);

/// The keyboard. Keys are given as meant() has them; nothing here needs a window.
class Input {
  public:
    /// The action of a key that went down; repeats of a key held down are none.
    std::optional<Action> key_down(SDL_Keycode key, bool repeat);
    void key_up(SDL_Keycode key);
    /// The window has lost the focus: it will not hear of keys that come up.
    void release_all();

    /// The steering for the frame to come. A key tapped between two frames counts as held for one.
    [[nodiscard]] Steering take_steering();
    /// Keys are held or were tapped: the next frame has something to do.
    [[nodiscard]] bool steers() const;

  private:
    static constexpr std::size_t kSteeringKeys = 6;

    struct Key {
        bool held = false;
        bool tapped = false;  ///< went down since the last frame
    };

    [[nodiscard]] Key* steering_key(SDL_Keycode key);

    std::array<Key, kSteeringKeys> keys_;
};

}  // namespace poolhall::client
