#pragma once

#include "shared/table/table.hpp"

#include <SDL2/SDL_rect.h>

#include <vector>

namespace poolhall::client {

/// The rubber of a table's rails, seen from above. All lengths in ball radii, y upwards.
class Cushions {
  public:
    /// `ball_radius` in metres.
    Cushions(const Table& table, double ball_radius);

    /// How a point lies to the rubber.
    struct Place {
        float outside = 1e6F;     ///< of its nearest face, nose or facing; negative inside
        SDL_FPoint normal{0, 0};  ///< unit, out of that face
    };

    [[nodiscard]] Place at(SDL_FPoint p) const;

  private:
    /// A point on a face and the way out of it.
    struct Face {
        SDL_FPoint on;
        SDL_FPoint normal;
    };

    /// A convex piece of rubber between two mouths; its back is not its own concern.
    using Piece = std::vector<Face>;

    void add_unbroken_rails(const Table& table);
    void add_end_game_rails(const Table& table);
    void add_pool_rails(const Table& table);
    [[nodiscard]] Face face(Vec2 on, Vec2 normal) const;

    double radius_;  ///< of a ball, m
    std::vector<Piece> pieces_;
};

}  // namespace poolhall::client
