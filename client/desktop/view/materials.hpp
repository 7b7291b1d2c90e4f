#pragma once

#include "client/desktop/render/colour.hpp"

namespace poolhall::client {

/// Woven cloth at a pixel; `light` 1 is full light.
[[nodiscard]] Rgb cloth(int pixel_x, int pixel_y, float light);

/// Polished mahogany; `along` and `across` the grain in ball radii.
[[nodiscard]] Rgb wood(float along, float across);

}  // namespace poolhall::client
