#include "client/desktop/view/layout.hpp"

#include <algorithm>

namespace poolhall::client {
namespace {

constexpr float kTopBar = 74;  // px at ui 1
constexpr float kBottomLines = 58;
constexpr float kSideMargin = 14;
constexpr float kMinUi = 0.6F;  // smaller text cannot be read

SDL_FRect around(SDL_FPoint centre, float width, float height) {
    return {centre.x - width / 2, centre.y - height / 2, width, height};
}

}  // namespace

SDL_FPoint Layout::to_pixels(Vec2 table_point) const {
    const double s = scale;
    return {centre.x + static_cast<float>(table_point.x * s),
            centre.y - static_cast<float>(table_point.y * s)};
}

Vec2 Layout::to_table(SDL_FPoint pixel) const {
    const double s = scale;
    return {static_cast<double>(pixel.x - centre.x) / s,
            static_cast<double>(centre.y - pixel.y) / s};
}

float ui_scale(int width, int height) {
    return std::max(std::min(static_cast<float>(width) / 1280, static_cast<float>(height) / 720),
                    kMinUi);
}

Layout layout_of(const Table& table, double ball_radius, int width, int height) {
    Layout layout;
    layout.width = width;
    layout.height = height;
    const auto w = static_cast<float>(width);
    const auto h = static_cast<float>(height);
    layout.ui = ui_scale(width, height);
    layout.top = {0, 0, w, kTopBar * layout.ui};
    layout.bottom = {0, h - kBottomLines * layout.ui, w, kBottomLines * layout.ui};

    const auto radius = static_cast<float>(ball_radius);
    const float frame = 2 * (kCushionWidth + kWoodWidth) * radius;
    const float length_m = static_cast<float>(table.length) + frame;
    const float width_m = static_cast<float>(table.width) + frame;
    const float free_width = w - 2 * kSideMargin * layout.ui;
    const float free_height = h - layout.top.h - layout.bottom.h;
    constexpr float kLeast = 8;  // px a metre; an output too small for a table still has a scale
    layout.scale = std::max(std::min(free_width / length_m, free_height / width_m), kLeast);
    layout.ball = radius * layout.scale;
    layout.centre = {w / 2, layout.top.h + free_height / 2};
    layout.table = around(layout.centre, length_m * layout.scale, width_m * layout.scale);
    layout.cloth = around(layout.centre, static_cast<float>(table.length) * layout.scale,
                          static_cast<float>(table.width) * layout.scale);
    return layout;
}

}  // namespace poolhall::client
