#pragma once

#include "client/desktop/render/image.hpp"
#include "client/desktop/render/mesh.hpp"
#include "client/desktop/render/rasterizer.hpp"
#include "client/desktop/render/sdl_ptr.hpp"

#include <SDL2/SDL.h>

#include <optional>

namespace poolhall::client {

/// The renderer's output in pixels: collects shapes and draws them in one batch, in order with
/// textures.
class Canvas {
  public:
    /// The renderer must outlive the canvas.
    explicit Canvas(SDL_Renderer* renderer);

    /// Starts a frame: takes over the renderer's size now and fills it.
    void begin(SDL_Color background);

    /// Draws what is still waiting in shapes().
    void finish() { flush(); }

    /// The device has lost its textures.
    void reset();

    [[nodiscard]] int width() const { return width_; }

    [[nodiscard]] int height() const { return height_; }

    /// Where shapes are added; they are drawn before the next copy().
    [[nodiscard]] Mesh& shapes() { return mesh_; }

    /// Draws the texture, blended, at `target` (px).
    void copy(SDL_Texture* texture, const SDL_FRect& target);
    /// Draws the texture, its alpha ignored, at `target` (px).
    void copy_opaque(SDL_Texture* texture, const SDL_FRect& target);

    /// Covers all that has been drawn so far.
    void veil(SDL_Color colour);

    /// Nothing when the device cannot hold it.
    [[nodiscard]] TexturePtr texture_of(const Image& image);

    [[nodiscard]] SDL_Renderer* renderer() const { return renderer_; }

  private:
    void flush();
    void flush_in_software();

    SDL_Renderer* renderer_;
    bool software_ = false;
    int width_ = 0;
    int height_ = 0;
    Mesh mesh_;
    Rasterizer rasterizer_;  ///< with the software renderer only
    TexturePtr layer_;       ///< its picture
};

}  // namespace poolhall::client
