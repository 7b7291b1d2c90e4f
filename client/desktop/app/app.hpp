#pragma once

#include "client/desktop/app/input.hpp"
#include "client/desktop/app/options.hpp"
#include "client/desktop/app/screen_stack.hpp"
#include "client/desktop/app/window.hpp"

#include <filesystem>

namespace poolhall::client {

/// The program: a window, the screens in it, and the loop that keeps them going.
class App {
  public:
    /// Throws std::runtime_error, one line, when there is nothing to show a table on.
    explicit App(const Options& options);

    /// Until the player leaves.
    void run();

  private:
    void handle_events();
    void handle(const SDL_Event& event);
    void handle_window(const SDL_WindowEvent& event);
    void press(SDL_Keycode key);
    void pass_time();
    void draw_if_needed();
    void draw();
    void take_screenshot();
    /// The frame rate, where it is asked for.
    [[nodiscard]] std::optional<double> frames_per_second() const;
    void note_frame(double now);
    /// How long it is until a frame may be drawn, s: none is drawn sooner than the display can show
    /// it, whether or not the renderer waits for that.
    [[nodiscard]] double next_frame_in() const;
    void await_next_frame();
    /// The window does not show how things stand.
    [[nodiscard]] bool stale() const;

    const std::filesystem::path screenshots_;
    Window window_;
    DrawingSurface surface_;
    ScreenStack screens_;

    bool running_ = true;
    bool redraw_ = true;  ///< what the window shows was lost
    bool screenshot_wanted_ = false;
    bool shows_frame_rate_ = false;
    double time_ = 0;          ///< of the last look at the clock, s
    bool was_moving_ = false;  ///< something moved then: time has passed since without a wait
    std::uint64_t drawn_revision_ = 0;
    double drawn_at_ = 0;           ///< when the last frame was begun, s
    bool drew_motion_ = false;      ///< something moved in it
    double frame_time_ = 1.0 / 60;  ///< s from one frame of a motion to the next, on average
};

}  // namespace poolhall::client
