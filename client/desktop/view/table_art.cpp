#include "client/desktop/view/table_art.hpp"

#include "client/desktop/view/table_painter.hpp"

namespace poolhall::client {
namespace {

constexpr double kSettling = 0.12;  // s

SDL_FRect to_float(const SDL_Rect& r) {
    return {static_cast<float>(r.x), static_cast<float>(r.y), static_cast<float>(r.w),
            static_cast<float>(r.h)};
}

}  // namespace

void TableArt::draw(Canvas& canvas, const Table& table, const Layout& layout, double now_s) {
    if (!(layout == seen_layout_)) {
        seen_layout_ = layout;
        seen_since_s_ = now_s;
    }
    const bool outdated = !(painted_layout_ == layout);
    if (!texture_ || !(painted_table_ == table) || (outdated && now_s - seen_since_s_ >= kSettling))
        paint(canvas, table, layout);
    if (texture_) canvas.copy_opaque(texture_.get(), to_float(table_picture_rect(layout)));
}

void TableArt::paint(Canvas& canvas, const Table& table, const Layout& layout) {
    texture_ = canvas.texture_of(paint_table(table, layout));
    painted_table_ = table;
    painted_layout_ = layout;
}

}  // namespace poolhall::client
