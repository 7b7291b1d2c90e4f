#pragma once

#include "client/desktop/render/drawing_surface.hpp"
#include "client/play/view_state.hpp"

#include <SDL2/SDL.h>

#include <memory>

namespace poolhall::client {

/// Draws what a ViewState says. It follows the surface's size by itself, and remembers only
/// what makes a picture continuous: how far each ball has rolled, and what has been baked into
/// textures.
class TableView {
  public:
    TableView();
    ~TableView();
    TableView(const TableView&) = delete;
    TableView& operator=(const TableView&) = delete;

    /// Draws over the whole surface, which must not be empty. `now_s` is any clock that only moves
    /// forward.
    void draw(DrawingSurface& surface, const ViewState& state, double now_s);
    /// The device has lost its textures.
    void reset();

    /// The point of the cloth (m) at a position in the renderer's pixels, as of the last draw.
    [[nodiscard]] Vec2 to_table(SDL_FPoint pixel) const;
    /// The position in the renderer's pixels of a point of the cloth (m), as of the last draw.
    [[nodiscard]] SDL_FPoint to_pixels(Vec2 table) const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace poolhall::client
