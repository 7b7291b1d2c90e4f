#include "client/desktop/view/solver_paths.hpp"

#include "client/desktop/render/colour.hpp"
#include "client/desktop/view/hud.hpp"
#include "client/desktop/view/overlays.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace poolhall::client {
namespace {

constexpr SDL_Color kInk{16, 19, 24, 255};
constexpr SDL_Color kBright{240, 242, 245, 255};
constexpr SDL_Color kDim{176, 184, 196, 255};

constexpr std::string_view kTitle = "The same shot by other solvers: CPU time, distance at rest";

/// Of the lines, in hairs.
constexpr std::array<float, kSolverViews> kWidths{4.4F, 2.5F, 1.1F};

Stroke stroke_of(const Layout& layout, std::size_t solver) {
    return {kWidths[solver % kWidths.size()] * hair(layout), solver_colour(solver)};
}

std::string title_of(const SolverView& solver) {
    return solver.decides ? solver.name + " (decides)" : solver.name;
}

/// The legend's measures, px.
struct Legend {
    float font;
    float row;
    float swatch;
    std::array<float, 3> columns{};  ///< widths of name, cost and distance
    SDL_FPoint size{};
};

TextStyle title_style(const Legend& legend) {
    return {0.85F * legend.font, kDim};
}

Legend legend_of(Text& text, const Layout& layout, std::span<const SolverView> solvers) {
    Legend legend{};
    legend.font = text_size(layout, 14);
    legend.row = 1.65F * legend.font;
    legend.swatch = 2.6F * legend.font;
    for (const SolverView& solver : solvers) {
        const std::array<std::string_view, 3> cells{solver.name, solver.cost, solver.distance};
        for (std::size_t i = 0; i < cells.size(); ++i)
            legend.columns[i] =
                std::max(legend.columns[i], text.width(cells[i], {legend.font, kBright, i == 0}));
        legend.columns[0] =
            std::max(legend.columns[0], text.width(title_of(solver), {legend.font, kBright, true}));
    }
    const float title = text.width(kTitle, title_style(legend));
    const float cells = legend.columns[0] + legend.columns[1] + legend.columns[2];
    legend.size = {std::max(legend.swatch + cells + 2.5F * legend.font, title) + 2 * legend.font,
                   legend.row * (static_cast<float>(solvers.size()) + 1.6F)};
    return legend;
}

void draw_row(Canvas& canvas, Text& text, const Layout& layout, const Legend& legend,
              const SolverView& solver, std::size_t place, SDL_FPoint at) {
    add_line(canvas.shapes(), {at.x, at.y}, {at.x + legend.swatch, at.y}, stroke_of(layout, place));
    float x = at.x + legend.swatch + legend.font;
    text.draw(title_of(solver), {legend.font, kBright, true}, {x, at.y});
    x += legend.columns[0] + 0.8F * legend.font + legend.columns[1];
    text.draw(solver.cost, {legend.font, kBright}, {x, at.y, Align::kRight});
    text.draw(solver.distance, {legend.font, kBright}, {x + 0.8F * legend.font, at.y});
}

bool holds(const SDL_FRect& box, SDL_FPoint point) {
    return point.x >= box.x && point.x <= box.x + box.w && point.y >= box.y &&
           point.y <= box.y + box.h;
}

/// How much of a line lies in the box: of its points, a tenth apart.
int hidden(const SDL_FRect& box, SDL_FPoint from, SDL_FPoint to) {
    constexpr int kParts = 10;
    int count = 0;
    for (int i = 0; i <= kParts; ++i) {
        const float share = static_cast<float>(i) / kParts;
        count += holds(box, {mix(from.x, to.x, share), mix(from.y, to.y, share)}) ? 1 : 0;
    }
    return count;
}

int hidden(const Layout& layout, const SDL_FRect& box, std::span<const SolverView> solvers) {
    constexpr int kBall = 200;  // worse to hide than a path
    const float edge = layout.ball;
    const SDL_FRect near{box.x - edge, box.y - edge, box.w + 2 * edge, box.h + 2 * edge};
    int count = 0;
    for (const SolverView& solver : solvers) {
        for (const Vec2 ball : solver.balls)
            count += holds(near, layout.to_pixels(ball)) ? kBall : 0;
        for (const auto& path : solver.paths) {
            for (std::size_t i = 1; i < path.size(); ++i)
                count += hidden(box, layout.to_pixels(path[i - 1]), layout.to_pixels(path[i]));
        }
    }
    return count;
}

}  // namespace

SDL_Color solver_colour(std::size_t solver) {
    // Okabe and Ito's sky blue and orange, and white: apart on green for every eye.
    constexpr std::array<SDL_Color, kSolverViews> kColours{
        {{86, 180, 233, 255}, {230, 159, 0, 255}, {255, 255, 255, 255}}};
    return kColours[solver % kColours.size()];
}

void add_solver_paths(Mesh& mesh, const Layout& layout, std::span<const SolverView> solvers) {
    for (std::size_t solver = 0; solver < solvers.size(); ++solver) {
        const Stroke stroke = stroke_of(layout, solver);
        for (const auto& path : solvers[solver].paths) {
            for (std::size_t i = 1; i < path.size(); ++i) {
                const SDL_FPoint to = layout.to_pixels(path[i]);
                add_line(mesh, layout.to_pixels(path[i - 1]), to, stroke);
                add_disc(mesh, to, stroke.width / 2, stroke.colour);  // rounds the corner
            }
        }
    }
}

void add_solver_ghosts(Mesh& mesh, const Layout& layout, std::span<const SolverView> solvers) {
    for (std::size_t solver = 0; solver < solvers.size(); ++solver) {
        const Stroke stroke = stroke_of(layout, solver);
        for (const Vec2 ball : solvers[solver].balls)
            add_ring(mesh, layout.to_pixels(ball), layout.ball,
                     {0.7F * stroke.width, stroke.colour});
    }
}

SDL_FRect legend_box(const Layout& layout, std::span<const SolverView> solvers, SDL_FPoint size) {
    const float gap = 0.6F * layout.ball;
    const SDL_FRect& cloth = layout.cloth;
    const float left = cloth.x + gap;
    const float right = cloth.x + cloth.w - gap - size.x;
    const float top = cloth.y + gap;
    const float bottom = cloth.y + cloth.h - gap - size.y;
    constexpr int kPlaces = 9;  // along each rail
    SDL_FRect best{};
    int least = std::numeric_limits<int>::max();
    for (int i = 0; i < 2 * kPlaces; ++i) {
        const int place = i / 2;
        const float share = static_cast<float>(place) / (kPlaces - 1);
        const SDL_FRect box{mix(left, right, share), i % 2 == 0 ? top : bottom, size.x, size.y};
        const int count = hidden(layout, box, solvers);
        if (count >= least) continue;
        least = count;
        best = box;
    }
    return best;
}

void draw_solver_legend(Canvas& canvas, Text& text, const Layout& layout,
                        std::span<const SolverView> solvers) {
    if (solvers.empty()) return;
    const Legend legend = legend_of(text, layout, solvers);
    const SDL_FRect box = legend_box(layout, solvers, legend.size);
    add_rounded_rect(canvas.shapes(), box, 0.5F * legend.font, faded(kInk, 0.80F));
    const float left = box.x + legend.font;
    float y = box.y + 0.8F * legend.row;
    text.draw(kTitle, title_style(legend), {left, y});
    for (std::size_t i = 0; i < solvers.size(); ++i)
        draw_row(canvas, text, layout, legend, solvers[i], i, {left, y += legend.row});
}

}  // namespace poolhall::client
