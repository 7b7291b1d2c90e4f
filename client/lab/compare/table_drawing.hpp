#pragma once

#include "client/lab/compare/drawing.hpp"
#include "shared/physics/scene/scene.hpp"

namespace poolhall::lab {

/// A stretch of the cloth, m.
struct Extent {
    Vec2 least;
    Vec2 most;
};

/// How the cloth lies on the page.
struct TableScale {
    double px_a_metre = 1;
    Pixel origin;  ///< of the cloth's middle

    [[nodiscard]] Pixel at(Vec2 r) const {
        return {origin.x + px_a_metre * r.x, origin.y - px_a_metre * r.y};
    }
};

/// The table with its rails and what lies behind them; for an endless cloth just the middle.
[[nodiscard]] Extent extent_of(const Table& table);

/// Cloth, rails, jaws and the places that capture balls, to scale, within the extent.
void draw_table(Drawing& drawing, const Scene& scene, const TableScale& scale,
                const Extent& extent);

}  // namespace poolhall::lab
