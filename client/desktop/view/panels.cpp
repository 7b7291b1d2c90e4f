#include "client/desktop/view/panels.hpp"

#include "client/desktop/render/colour.hpp"
#include "client/desktop/view/help_text.hpp"
#include "client/desktop/view/hud.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace poolhall::client {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr SDL_Color kInk{16, 19, 24, 255};
constexpr SDL_Color kBright{245, 246, 248, 255};
constexpr SDL_Color kDim{190, 197, 207, 255};
constexpr SDL_Color kWon{255, 205, 84, 255};
constexpr SDL_Color kLost{255, 128, 104, 255};
constexpr SDL_Color kNeutral{150, 190, 235, 255};

SDL_Color colour_of(Tone tone) {
    switch (tone) {
        case Tone::kWon:
            return kWon;
        case Tone::kLost:
            return kLost;
        case Tone::kNeutral:
            return kNeutral;
    }
    return kNeutral;
}

void add_star(Mesh& mesh, SDL_FPoint middle, float radius, SDL_Color colour) {
    std::array<SDL_FPoint, 10> corners{};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const float angle = (static_cast<float>(i) / 5 - 0.5F) * kPi;
        const float r = i % 2 == 0 ? radius : 0.42F * radius;
        corners[i] = {middle.x + r * std::cos(angle), middle.y + r * std::sin(angle)};
    }
    add_star_shape(mesh, middle, corners, colour);
}

// A star for won, a cross for lost, three dots for the rest.
void add_symbol(Mesh& mesh, SDL_FPoint middle, float radius, Tone tone) {
    const SDL_Color colour = colour_of(tone);
    const float part = 0.34F * radius;
    if (tone == Tone::kWon) {
        add_disc(mesh, middle, radius, colour);
        add_star(mesh, middle, 0.74F * radius, kInk);
        return;
    }
    if (tone == Tone::kLost) {
        add_disc(mesh, middle, radius, colour);
        const Stroke stroke{0.22F * radius, kInk};
        add_line(mesh, {middle.x - part, middle.y - part}, {middle.x + part, middle.y + part},
                 stroke);
        add_line(mesh, {middle.x + part, middle.y - part}, {middle.x - part, middle.y + part},
                 stroke);
        return;
    }
    add_ring(mesh, middle, 0.92F * radius, {0.14F * radius, colour});
    for (const float x : {-1.2F, 0.0F, 1.2F})
        add_disc(mesh, {middle.x + x * part, middle.y}, 0.13F * radius, colour);
}

void add_panel(Mesh& mesh, const SDL_FRect& box, float radius, SDL_Color edge) {
    // A soft shadow, of frames rather than whole rectangles: large areas are dear where there is no
    // graphics card.
    constexpr int kSteps = 6;
    const float step = radius / 8;
    for (int i = 0; i < kSteps; ++i) {
        const float grown = (static_cast<float>(i) + 0.5F) * step;
        const float fade = 1 - static_cast<float>(i) / kSteps;
        add_rounded_frame(
            mesh, {box.x - grown, box.y - 0.6F * grown, box.w + 2 * grown, box.h + 2 * grown},
            radius + grown, {1.3F * step, {0, 0, 0, static_cast<Uint8>(90 * fade * fade)}});
    }
    add_rounded_rect(mesh, box, radius, faded(kInk, 0.91F));
    add_rounded_frame(mesh, box, radius, {std::max(1.5F, radius / 9), edge});
}

void add_key_cap(Mesh& mesh, const SDL_FRect& box) {
    const float rounding = 0.23F * box.h;
    add_rounded_rect(mesh, box, rounding, {58, 64, 76, 255});
    add_rounded_frame(mesh, box, rounding, {1, {96, 104, 120, 255}});
}

// Column widths and heights of the help screen, px.
struct HelpGrid {
    SDL_FRect box;
    float row;
    float keys;
    float font;
    float rounding;
};

HelpGrid help_grid(Text& text, const Canvas& canvas) {
    const auto w = static_cast<float>(canvas.width());
    const auto h = static_cast<float>(canvas.height());
    const float ui = ui_scale(canvas.width(), canvas.height());
    constexpr float kRows = static_cast<float>(kKeyTable.size()) + 3.2F;  // with title, margins
    HelpGrid grid{};
    grid.row = std::min(36 * ui, (h - 8) / kRows);
    grid.font = std::max(std::min(16 * ui, 0.62F * grid.row), 9.0F);
    grid.rounding = std::min(16 * ui, grid.row);
    float actions = 0;
    for (const KeyRow& key : kKeyTable) {
        grid.keys = std::max(grid.keys, text.width(key.key, {grid.font, kBright, true}));
        actions = std::max(actions, text.width(key.action, {grid.font, kBright}));
    }
    const float width = std::min(grid.keys + actions + 6 * grid.row, w - 8);
    const float height = kRows * grid.row;
    grid.box = {(w - width) / 2, (h - height) / 2, width, height};
    return grid;
}

}  // namespace

void draw_banner(Canvas& canvas, Text& text, const Layout& layout, const Banner& banner) {
    const float ui = layout.ui;
    const SDL_Color colour = colour_of(banner.tone);
    const float title = text_size(layout, 52);
    const float subtitle = text_size(layout, 20);
    const float symbol = 0.72F * title;
    const float widest = 0.92F * static_cast<float>(layout.width);
    const float beside = 2 * symbol + 96 * ui;
    const float wanted = std::max(text.width(banner.title, {title, colour, true}),
                                  text.width(banner.subtitle, {subtitle, kDim}));
    const float width = std::min(wanted + beside, widest);
    const bool two_lines = !banner.subtitle.empty();
    const float height = 1.25F * title + (two_lines ? 1.7F * subtitle : 0) + 40 * ui;
    const SDL_FRect box{layout.centre.x - width / 2, layout.centre.y - height / 2, width, height};
    add_panel(canvas.shapes(), box, 18 * ui, colour);
    add_symbol(canvas.shapes(), {box.x + 32 * ui + symbol, layout.centre.y}, symbol, banner.tone);
    const float left = box.x + 2 * symbol + 60 * ui;
    const float room = box.x + box.w - left - 24 * ui;
    const float first = two_lines ? box.y + 20 * ui + 0.6F * title : layout.centre.y;
    text.draw(banner.title, {title, colour, true}, {left, first, Align::kLeft, room});
    text.draw(banner.subtitle, {subtitle, kDim},
              {left, first + 0.75F * title + 0.75F * subtitle, Align::kLeft, room});
}

void draw_help(Canvas& canvas, Text& text) {
    const HelpGrid grid = help_grid(text, canvas);
    canvas.veil({0, 0, 0, 120});
    Mesh& shapes = canvas.shapes();
    add_panel(shapes, grid.box, grid.rounding, {92, 100, 116, 255});
    const TextStyle key_style{grid.font, kBright, true};
    const float left = grid.box.x + 1.2F * grid.row;
    const float title = grid.box.y + 1.25F * grid.row;
    const float first = title + 1.25F * grid.row;
    // All shapes before all text: each change from one to the other is another batch.
    float y = first;
    for (const KeyRow& key : kKeyTable) {
        const float cap = text.width(key.key, key_style) + 0.8F * grid.row;
        add_key_cap(shapes, {left, y - 0.39F * grid.row, cap, 0.78F * grid.row});
        y += grid.row;
    }
    const float right = grid.box.x + grid.box.w;
    text.draw("Keys and mouse", {1.4F * grid.font, kWon, true}, {left, title});
    text.draw("F1 closes this", {0.9F * grid.font, kDim},
              {right - 1.2F * grid.row, title, Align::kRight});
    const float column = left + grid.keys + 1.5F * grid.row;
    y = first;
    for (const KeyRow& key : kKeyTable) {
        text.draw(key.key, key_style, {left + 0.4F * grid.row, y});
        text.draw(key.action, {grid.font, kDim},
                  {column, y, Align::kLeft, right - column - 0.5F * grid.row});
        y += grid.row;
    }
}

}  // namespace poolhall::client
