#pragma once

#include "client/desktop/render/canvas.hpp"
#include "client/desktop/view/layout.hpp"

namespace poolhall::client {

/// The bare table as a texture. While the window is being resized the old picture is stretched; it
/// is painted anew once the size has settled.
class TableArt {
  public:
    void draw(Canvas& canvas, const Table& table, const Layout& layout, double now_s);

    void reset() { texture_.reset(); }

  private:
    void paint(Canvas& canvas, const Table& table, const Layout& layout);

    TexturePtr texture_;
    Table painted_table_;
    Layout painted_layout_;
    Layout seen_layout_;
    double seen_since_s_ = 0;
};

}  // namespace poolhall::client
