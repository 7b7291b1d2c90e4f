#pragma once

#include "shared/table/table.hpp"

#include <SDL2/SDL_rect.h>

namespace poolhall::client {

/// Smallest window in which everything can be read, in points.
inline constexpr int kMinWindowWidth = 480;
inline constexpr int kMinWindowHeight = 320;

/// Where everything is in an output of a given size, in pixels with y downwards. The table keeps
/// its proportions; what is left of the output stays empty.
struct Layout {
    int width = 0;  ///< of the output
    int height = 0;
    float ui = 1;             ///< scale of text and icons; 1 at 1280 x 720
    float scale = 1;          ///< px a metre
    float ball = 1;           ///< radius of a ball, px
    SDL_FPoint centre{0, 0};  ///< of the table
    SDL_FRect table{};        ///< with its wooden frame
    SDL_FRect cloth{};        ///< from nose to nose
    SDL_FRect top{};          ///< bar over the table
    SDL_FRect bottom{};       ///< lines below the table

    [[nodiscard]] SDL_FPoint to_pixels(Vec2 table_point) const;
    [[nodiscard]] Vec2 to_table(SDL_FPoint pixel) const;

    friend bool operator==(const Layout& a, const Layout& b) {
        return a.width == b.width && a.height == b.height && a.scale == b.scale && a.ball == b.ball;
    }
};

/// Widths of the frame's parts, in ball radii.
inline constexpr float kCushionWidth = 1.8F;
inline constexpr float kWoodWidth = 2.7F;

/// Of text and icons on an output of that size.
[[nodiscard]] float ui_scale(int width, int height);

/// `ball_radius` in metres. Any size is taken; below 64 px nothing can be made out.
[[nodiscard]] Layout layout_of(const Table& table, double ball_radius, int width, int height);

}  // namespace poolhall::client
