#pragma once

#include <SDL2/SDL.h>

#include <memory>
#include <stdexcept>
#include <string>

namespace poolhall::client {

/// SDL could not do what the program cannot go on without; what() is one line.
class WindowError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// SDL's video, the window and its renderer.
class Window {
  public:
    /// `width` and `height` in points. Throws WindowError.
    Window(const std::string& title, int width, int height);

    [[nodiscard]] SDL_Renderer& renderer() { return *renderer_; }

    /// Where a position of the mouse is in the renderer's pixels (they differ on HiDPI displays).
    [[nodiscard]] SDL_FPoint to_pixels(int x, int y) const;

    /// From one picture of the display that it is on to the next, s; 1/60 where that is not known.
    [[nodiscard]] double frame_time() const;

    /// Nobody can see it: minimised or hidden.
    [[nodiscard]] bool out_of_sight() const;
    void set_title(const std::string& title);

  private:
    struct Sdl {
        Sdl();
        ~Sdl();
        Sdl(const Sdl&) = delete;
        Sdl& operator=(const Sdl&) = delete;
    };

    struct Destroy {
        void operator()(SDL_Window* window) const { SDL_DestroyWindow(window); }

        void operator()(SDL_Renderer* renderer) const { SDL_DestroyRenderer(renderer); }
    };

    Sdl sdl_;
    std::unique_ptr<SDL_Window, Destroy> window_;
    std::unique_ptr<SDL_Renderer, Destroy> renderer_;
    std::string title_;
};

}  // namespace poolhall::client
