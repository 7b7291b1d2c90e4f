#pragma once

#include "client/desktop/render/drawing_surface.hpp"

#include <SDL2/SDL.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <string>

namespace poolhall::client {

/// An event as a screen takes it.
struct ScreenEvent {
    const SDL_Event& sdl;
    SDL_Keycode key = SDLK_UNKNOWN;  ///< that went down or up, as meant() has it
    SDL_FPoint pointer{0, 0};        ///< of an event of the mouse: where it is, px
};

/// What became of an event.
enum class Answer : std::uint8_t {
    kPassed,  ///< the screen below may have it, and the program after the last
    kTaken,
    kClose,  ///< taken, and the screen has no more to do
};

/// One frame to be drawn.
struct Frame {
    DrawingSurface& surface;
    double now = 0;                           ///< s
    std::optional<double> frames_per_second;  ///< to be shown; 0 while nothing moves
};

/// One of those that lie upon each other in the window: the table, the help over it.
class Screen {
  public:
    Screen() = default;
    Screen(const Screen&) = delete;
    Screen& operator=(const Screen&) = delete;
    virtual ~Screen() = default;

    virtual Answer handle(const ScreenEvent& event) = 0;

    /// Lets `dt` s pass until `now` (s).
    virtual void update(double /*dt*/, double /*now*/) {}

    /// Draws it over what is there.
    virtual void draw(const Frame& frame) = 0;

    /// It changes by itself from frame to frame.
    [[nodiscard]] virtual bool moves() const { return false; }

    /// Rises whenever it would look different.
    [[nodiscard]] virtual std::uint64_t revision() const { return 0; }

    /// How long update() may wait when nothing happens, s.
    [[nodiscard]] virtual double due_in(double /*now*/) const {
        return std::numeric_limits<double>::infinity();
    }

    /// Of the window; empty to leave that to the screen below.
    [[nodiscard]] virtual std::string title() const { return ""; }

    /// Shows a line of the program's for a while; false if it has no place for one.
    virtual bool show_status(const std::string& /*line*/) { return false; }
};

}  // namespace poolhall::client
