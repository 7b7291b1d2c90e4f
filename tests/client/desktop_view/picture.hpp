#pragma once

#include "client/desktop/render/sdl_ptr.hpp"
#include "client/desktop/view/panels.hpp"
#include "client/desktop/view/table_painter.hpp"
#include "client/desktop/view/table_view.hpp"
#include "tests/client/desktop_view/sample_views.hpp"

#include <SDL2/SDL.h>

#include <memory>

namespace poolhall::client {

/// Views on a surface in memory, drawn by SDL's software renderer.
class Picture {
  public:
    explicit Picture(SDL_Point size)
        : surface_(SDL_CreateRGBSurfaceWithFormat(0, size.x, size.y, 32, SDL_PIXELFORMAT_ARGB8888)),
          renderer_(SDL_CreateSoftwareRenderer(surface_.get())),
          drawing_(std::make_unique<DrawingSurface>(renderer_.get())) {}

    /// Draws the view; then whatever `over` draws over it.
    template <class Over>
    void draw(const ViewState& state, double now_s, Over over) {
        drawing_->canvas.begin(to_colour(kRoom));
        view_.draw(*drawing_, state, now_s);
        over(*drawing_);
        drawing_->canvas.finish();
        SDL_RenderFlush(renderer_.get());
    }

    void draw(const ViewState& state, double now_s = 0) {
        draw(state, now_s, [](DrawingSurface&) {});
    }

    void draw(const samples::NamedView& view) {
        draw(view.state, 1, [&view](DrawingSurface& surface) {
            if (view.help) draw_help(surface.canvas, surface.text);
        });
    }

    /// The device has lost its textures.
    void reset() {
        drawing_->reset();
        view_.reset();
    }

    [[nodiscard]] SDL_Renderer* renderer() { return renderer_.get(); }

    [[nodiscard]] SDL_Surface* surface() { return surface_.get(); }

    /// Black where there is no such pixel.
    [[nodiscard]] SDL_Color at(SDL_FPoint pixel) const {
        const int x = static_cast<int>(pixel.x);
        const int y = static_cast<int>(pixel.y);
        SDL_Color colour{0, 0, 0, 255};
        if (x < 0 || y < 0 || x >= surface_->w || y >= surface_->h) return colour;
        const auto* row = static_cast<const Uint8*>(surface_->pixels) +
                          static_cast<std::ptrdiff_t>(y) * surface_->pitch;
        SDL_GetRGB(reinterpret_cast<const Uint32*>(row)[x], surface_->format, &colour.r, &colour.g,
                   &colour.b);
        return colour;
    }

  private:
    struct DestroyRenderer {
        void operator()(SDL_Renderer* owned) const { SDL_DestroyRenderer(owned); }
    };

    SurfacePtr surface_;
    std::unique_ptr<SDL_Renderer, DestroyRenderer> renderer_;
    std::unique_ptr<DrawingSurface> drawing_;
    TableView view_;
};

}  // namespace poolhall::client
