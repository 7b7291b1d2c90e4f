#pragma once

#include "client/desktop/render/canvas.hpp"
#include "client/desktop/render/text.hpp"

namespace poolhall::client {

/// What screens are drawn on: shapes, pictures and lines of text.
struct DrawingSurface {
    /// Throws std::runtime_error, one line, where there is no font. The renderer must outlive it.
    explicit DrawingSurface(SDL_Renderer* renderer) : canvas(renderer), text(canvas) {}

    /// The device has lost its textures.
    void reset() {
        canvas.reset();
        text.reset();
    }

    Canvas canvas;
    Text text;
};

}  // namespace poolhall::client
