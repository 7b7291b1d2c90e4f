#pragma once

#include "client/desktop/app/options.hpp"
#include "client/desktop/app/table_controller.hpp"
#include "client/desktop/app/window.hpp"
#include "client/desktop/audio/sounds.hpp"
#include "client/desktop/net/token_store.hpp"
#include "client/desktop/view/table_view.hpp"
#include "client/play/transport.hpp"

#include <memory>

namespace poolhall::client {

/// The program: a window, a match and the loop that connects them.
class App {
  public:
    /// Throws std::runtime_error, one line, when there is nothing to show a table on.
    explicit App(const Options& options);

    /// Until the player leaves.
    void run();

  private:
    [[nodiscard]] std::unique_ptr<ClientMatch> make_match(const Options& options);
    void handle_events();
    void handle(const SDL_Event& event);
    void handle_window(const SDL_WindowEvent& event);
    void handle_key(const SDL_KeyboardEvent& event);
    void act(Action action);
    void copy_code();
    [[nodiscard]] Vec2 on_table(int x, int y) const;
    void pass_time();
    void play_sounds();
    void draw_if_needed();
    void draw();
    void take_screenshot();
    void pace();
    /// The window does not show how things stand.
    [[nodiscard]] bool stale() const;
    /// Something moves: frame follows frame, without waiting for events.
    [[nodiscard]] bool busy() const;

    const std::filesystem::path screenshots_;
    Window window_;
    TableView view_;
    Sounds sounds_;
    TokenStore tokens_;
    Playback playback_;
    std::unique_ptr<Transport> transport_;
    std::unique_ptr<ClientMatch> match_;
    TableController controller_;
    Input input_;

    bool running_ = true;
    bool redraw_ = true;  ///< what the window shows was lost
    bool screenshot_wanted_ = false;
    double time_ = 0;        ///< of the last frame, s
    bool was_busy_ = false;  ///< the last frame followed its predecessor without a wait
    std::uint64_t drawn_revision_ = 0;
    double frame_time_ = 1.0 / 60;  ///< s from one frame to the next, on average
};

}  // namespace poolhall::client
