#pragma once

#include "client/desktop/render/image.hpp"
#include "client/desktop/render/mesh.hpp"

#include <SDL2/SDL_rect.h>

#include <vector>

namespace poolhall::client {

/// Draws meshes into memory, at 1/256 of a pixel. SDL's own software renderer rounds the corners of
/// triangles to whole pixels, which makes feathered edges jagged.
class Rasterizer {
  public:
    /// Makes an empty layer of this size; what was drawn is lost.
    void resize(int width, int height);
    /// Draws the mesh over the layer.
    void draw(const Mesh& mesh);
    /// Bands of whole rows' parts that hold everything drawn since clear(), for copying without the
    /// empty rest.
    [[nodiscard]] std::vector<SDL_Rect> dirty_bands() const;
    void clear();

    [[nodiscard]] const Image& layer() const { return layer_; }

  private:
    struct Extent {
        int from = 0;
        int to = 0;  ///< exclusive; nothing drawn where it is not above `from`
    };

    void draw_triangle(const SDL_Vertex& a, const SDL_Vertex& b, const SDL_Vertex& c);

    Image layer_;
    std::vector<Extent> extents_;  ///< one a row
};

}  // namespace poolhall::client
