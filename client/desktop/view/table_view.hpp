#pragma once

#include "client/play/view_state.hpp"

#include <SDL2/SDL.h>

#include <memory>

namespace poolhall::client {

/// Smallest window in which everything can be read, in points.
inline constexpr int kMinWindowWidth = 480;
inline constexpr int kMinWindowHeight = 320;

/// Draws what a ViewState says. It follows the renderer's output size by itself, and remembers only
/// what makes a picture continuous: how far each ball has rolled, and what has been baked into
/// textures.
class TableView {
  public:
    /// Throws std::runtime_error, one line, where no font can be found. The renderer must outlive
    /// the view.
    explicit TableView(SDL_Renderer* renderer);
    ~TableView();
    TableView(const TableView&) = delete;
    TableView& operator=(const TableView&) = delete;

    /// Draws the whole output; presenting is the caller's. `now_s` is any clock that only moves
    /// forward.
    void draw(const ViewState& state, double now_s);
    /// Rebuilds the textures when the event says that the device has lost them.
    void handle_event(const SDL_Event& event);

    /// The point of the cloth (m) at a position in the renderer's pixels, as of the last draw.
    [[nodiscard]] Vec2 to_table(SDL_FPoint pixel) const;
    /// The position in the renderer's pixels of a point of the cloth (m), as of the last draw.
    [[nodiscard]] SDL_FPoint to_pixels(Vec2 table) const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace poolhall::client
