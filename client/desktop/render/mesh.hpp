#pragma once

#include <SDL2/SDL_render.h>

#include <span>
#include <vector>

namespace poolhall::client {

/// Triangles for SDL_RenderGeometry, in pixels with y downwards.
struct Mesh {
    std::vector<SDL_Vertex> vertices;
    std::vector<int> indices;

    [[nodiscard]] bool empty() const { return indices.empty(); }

    void clear() {
        vertices.clear();
        indices.clear();
    }
};

struct Stroke {
    float width = 1;  ///< px; below 1 it is drawn 1 px wide and fainter
    SDL_Color colour;
};

// Every edge is feathered: alpha falls from full to nothing across the pixel around it, so that
// shapes are anti-aliased at any scale and the alpha that a shape adds up to is its area.

void add_disc(Mesh& mesh, SDL_FPoint centre, float radius, SDL_Color colour);
/// `radius` is that of the stroke's middle.
void add_ring(Mesh& mesh, SDL_FPoint centre, float radius, Stroke stroke);

/// Angles in radians, clockwise on the screen from the right.
struct Sweep {
    float from = 0;
    float to = 0;
};

void add_arc(Mesh& mesh, SDL_FPoint centre, float radius, Sweep sweep, Stroke stroke);
void add_line(Mesh& mesh, SDL_FPoint from, SDL_FPoint to, Stroke stroke);
/// Dashes of `dash` px with gaps as long.
void add_dashed_line(Mesh& mesh, SDL_FPoint from, SDL_FPoint to, float dash, Stroke stroke);
/// A convex polygon of three corners or more, clockwise on the screen.
void add_convex(Mesh& mesh, std::span<const SDL_FPoint> corners, SDL_Color colour);
/// A polygon of three corners or more, clockwise on the screen, all of which `middle` sees.
void add_star_shape(Mesh& mesh, SDL_FPoint middle, std::span<const SDL_FPoint> corners,
                    SDL_Color colour);
void add_rounded_rect(Mesh& mesh, const SDL_FRect& rect, float radius, SDL_Color colour);
/// The outline of add_rounded_rect, the stroke's middle on its edge.
void add_rounded_frame(Mesh& mesh, const SDL_FRect& rect, float radius, Stroke stroke);
/// An ellipse that fades from the middle to nothing at its edge: a soft shadow.
void add_glow(Mesh& mesh, SDL_FPoint centre, SDL_FPoint radii, SDL_Color colour);

}  // namespace poolhall::client
