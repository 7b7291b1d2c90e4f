#pragma once

#include "client/desktop/render/colour.hpp"
#include "client/desktop/render/image.hpp"
#include "client/desktop/view/layout.hpp"

namespace poolhall::client {

/// What is around the table.
inline constexpr Rgb kRoom{0.082F, 0.090F, 0.106F};

/// Where the picture of the table with its shadow goes, in whole pixels.
[[nodiscard]] SDL_Rect table_picture_rect(const Layout& layout);

/// The bare table: cloth, cushions, pockets, wood, and its shadow on kRoom. Opaque. About 60 ns a
/// pixel, so it is for baking, not for each frame.
[[nodiscard]] Image paint_table(const Table& table, const Layout& layout);

}  // namespace poolhall::client
