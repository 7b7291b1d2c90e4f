#include "client/lab/compare/picture.hpp"

#include "client/compare/number_text.hpp"
#include "client/lab/compare/table_drawing.hpp"
#include "client/lab/input/scene_source.hpp"
#include "client/text/text_line.hpp"
#include "shared/analysis/agreement.hpp"
#include "shared/analysis/paths.hpp"

#include <algorithm>
#include <array>
#include <cairo-svg.h>
#include <cmath>

namespace poolhall::lab {

namespace {

using compare::Comparison;
using compare::SolverRun;
using compare::text_of_cost;
using compare::text_of_distance;

constexpr double kMargin = 40;  // px
constexpr double kPageWidth = 1600;
constexpr double kMostTableHeight = 1400;
constexpr double kTitle = 84;  // height of the title's line
constexpr double kLegendRow = 40;
constexpr double kLegendFont = 23;
constexpr double kFinest = 1e-4;  // m; what is left out of a path is less than this aside

// Okabe and Ito's colours, told apart by all eyes, without those too light for a light cloth.
constexpr std::array<Colour, 7> kColours{{{0, 0, 0},
                                          {0.835, 0.369, 0},
                                          {0, 0.447, 0.698},
                                          {0, 0.620, 0.451},
                                          {0.800, 0.475, 0.655},
                                          {0.902, 0.624, 0},
                                          {0.337, 0.706, 0.914}}};
constexpr Colour kInk{0.12, 0.12, 0.12};
constexpr Colour kDim{0.40, 0.40, 0.40};
constexpr Colour kPaper{1, 1, 1};

/// Dashes, that the lines can be told apart in grey as well.
std::vector<double> dash_of(std::size_t solver) {
    switch (solver % 4) {
        case 1:
            return {22, 7};
        case 2:
            return {9, 6};
        case 3:
            return {3, 5};
        default:
            return {};
    }
}

/// Later solvers are drawn over earlier ones, and thinner.
Pen pen_of(std::size_t solver, std::size_t count) {
    const double share =
        count > 1 ? static_cast<double>(solver) / static_cast<double>(count - 1) : 1;
    return {kColours[solver % kColours.size()], 7.5 - 5 * share, dash_of(solver)};
}

void widen(Extent& extent, Vec2 r, double by) {
    extent.least = {std::min(extent.least.x, r.x - by), std::min(extent.least.y, r.y - by)};
    extent.most = {std::max(extent.most.x, r.x + by), std::max(extent.most.y, r.y + by)};
}

/// One picture of a comparison; draws in layers.
class Page {
  public:
    Page(const Scene& scene, const Comparison& comparison);

    [[nodiscard]] double height() const {
        return kTitle + table_height_ + kMargin +
               kLegendRow * (static_cast<double>(comparison_.runs.size()) + 2.5);
    }

    void draw(Drawing& drawing) const;

  private:
    void draw_title(Drawing& drawing) const;
    void draw_balls(Drawing& drawing) const;
    void draw_paths(Drawing& drawing, std::size_t solver) const;
    void draw_ends(Drawing& drawing, std::size_t solver) const;
    void draw_legend(Drawing& drawing) const;
    void draw_legend_row(Drawing& drawing, std::size_t solver, double y) const;
    [[nodiscard]] std::array<std::string, 4> legend_of(const SolverRun& run) const;

    [[nodiscard]] double radius(std::size_t ball) const {
        return scale_.px_a_metre * radius_of(scene_, scene_.balls[ball]);
    }

    [[nodiscard]] Pen pen(std::size_t solver) const {
        return pen_of(solver, comparison_.runs.size());
    }

    /// By solver and ball; no line for a ball that never moved.
    [[nodiscard]] bool moved(std::size_t solver, std::size_t ball) const {
        return outlines_[solver][ball].size() > 1;
    }

    const Scene& scene_;
    const Comparison& comparison_;
    std::vector<std::vector<std::vector<Vec2>>> outlines_;
    Extent extent_;
    TableScale scale_;
    double table_height_ = 0;  ///< px
};

std::vector<std::vector<Vec2>> outlines_of(const Scene& scene, const SolverRun& run) {
    std::vector<std::vector<Vec2>> outlines;
    if (run.refusal) return outlines;
    for (const analysis::Path& path : analysis::paths_of(scene, run.trace)) {
        auto outline = analysis::outline_of(path, kFinest);
        if (outline.size() == 2 && outline[0] == outline[1]) outline.pop_back();
        outlines.push_back(std::move(outline));
    }
    return outlines;
}

Page::Page(const Scene& scene, const Comparison& comparison)
    : scene_(scene), comparison_(comparison), extent_(extent_of(scene.table)) {
    for (const SolverRun& run : comparison.runs) {
        outlines_.push_back(outlines_of(scene, run));
        for (std::size_t i = 0; i < outlines_.back().size(); ++i) {
            for (const Vec2 r : outlines_.back()[i])
                widen(extent_, r, 2 * radius_of(scene, scene.balls[i]));
        }
    }
    const Vec2 size = extent_.most - extent_.least;
    scale_.px_a_metre = std::min((kPageWidth - 2 * kMargin) / size.x, kMostTableHeight / size.y);
    table_height_ = scale_.px_a_metre * size.y;
    const Vec2 middle = 0.5 * (extent_.least + extent_.most);
    scale_.origin = {kPageWidth / 2 - scale_.px_a_metre * middle.x,
                     kTitle + table_height_ / 2 + scale_.px_a_metre * middle.y};
}

void Page::draw(Drawing& drawing) const {
    drawing.fill_rectangle({0, 0}, kPageWidth, height() + 1, kPaper);
    draw_title(drawing);
    draw_table(drawing, scene_, scale_, extent_);
    draw_balls(drawing);
    for (std::size_t i = 0; i < outlines_.size(); ++i)
        draw_paths(drawing, i);
    for (std::size_t i = 0; i < outlines_.size(); ++i)
        draw_ends(drawing, i);
    draw_legend(drawing);
}

void Page::draw_title(Drawing& drawing) const {
    const std::string shot = scene_.id.empty() ? "The same shot" : scene_.id + ": the same shot";
    drawing.text(shot + " by " + std::to_string(comparison_.runs.size()) + " solvers",
                 {34, kInk, true}, {kMargin, 54});
}

void Page::draw_balls(Drawing& drawing) const {
    for (std::size_t i = 0; i < scene_.balls.size(); ++i) {
        const Pixel at = scale_.at(xy(scene_.balls[i].state.r));
        drawing.disc(at, radius(i), kPaper);
        drawing.ring(at, radius(i), {kDim, 1.5});
        const TextFont font{17, kDim};
        const std::string& id = scene_.balls[i].id;
        const bool fits = drawing.width_of(id, font) < 1.5 * radius(i);
        drawing.centred_text(id, font, {at.x, at.y + (fits ? 6 : radius(i) + 19)});
    }
}

void Page::draw_paths(Drawing& drawing, std::size_t solver) const {
    for (std::size_t ball = 0; ball < outlines_[solver].size(); ++ball) {
        if (!moved(solver, ball)) continue;
        std::vector<Pixel> corners;
        for (const Vec2 r : outlines_[solver][ball])
            corners.push_back(scale_.at(r));
        drawing.line(corners, pen(solver));
    }
}

void Page::draw_ends(Drawing& drawing, std::size_t solver) const {
    const Colour colour = pen(solver).colour;
    const double size = 0.6 * scale_.px_a_metre * scene_.ball.radius;
    for (const Vec2 r : analysis::impacts_of(comparison_.runs[solver].trace))
        drawing.cross(scale_.at(r), size, {colour, 2});
    for (std::size_t ball = 0; ball < outlines_[solver].size(); ++ball) {
        if (!moved(solver, ball)) continue;
        const Pixel end = scale_.at(outlines_[solver][ball].back());
        drawing.ring(end, radius(ball), {colour, 2.5});
        drawing.disc(end, 0.3 * radius(ball), colour);
    }
}

constexpr std::array<double, 4> kLegendColumns{170, 420, 590, 920};  // px

void Page::draw_legend(Drawing& drawing) const {
    double y = kTitle + table_height_ + kMargin + 10;
    const std::string reference = compare::label(comparison_.runs[*comparison_.reference].solver);
    const std::array<std::string, 4> heads{"solver", "CPU time", "farthest ball at rest",
                                           "same events as " + reference};
    for (std::size_t i = 0; i < heads.size(); ++i)
        drawing.text(heads[i], {19, kDim}, {kLegendColumns[i], y});
    for (std::size_t i = 0; i < comparison_.runs.size(); ++i)
        draw_legend_row(drawing, i, y += kLegendRow);
    drawing.text(
        "Circle: a ball at the start. Cross: a ball when it met another or a rail. Ring "
        "with a dot: where it came to rest or fell.",
        {19, kDim}, {kMargin, y + kLegendRow});
}

void Page::draw_legend_row(Drawing& drawing, std::size_t solver, double y) const {
    const SolverRun& run = comparison_.runs[solver];
    const double middle = y - 0.35 * kLegendFont;
    if (!run.refusal)
        drawing.line(std::array{Pixel{kMargin, middle}, Pixel{kLegendColumns[0] - 20, middle}},
                     pen(solver));
    const auto cells = legend_of(run);
    for (std::size_t i = 0; i < cells.size(); ++i)
        drawing.text(cells[i], {kLegendFont, kInk, i == 0}, {kLegendColumns[i], y});
}

std::array<std::string, 4> Page::legend_of(const SolverRun& run) const {
    const std::string label = compare::label(run.solver);
    if (run.refusal) return {label, "refused: " + text_of(*run.refusal), "", ""};
    const SolverRun& reference = comparison_.runs[*comparison_.reference];
    const std::string cost = text_of_cost(run.cpu_ns);
    if (&run == &reference) return {label, cost, "the reference", ""};
    const auto farthest = compare::farthest_ball(run);
    const std::string matching = std::to_string(run.agreement.matching.size()) + " of " +
                                 std::to_string(reference.trace.events.size());
    const bool same_verdict = analysis::is_same_verdict(reference.trace, run.trace);
    return {
        label, cost,
        text_of_distance(farthest->distance) + " (" + scene_.balls[farthest->ball.value].id + ")",
        (run.agreement.complete() ? "all" : "the first " + matching) +
            (same_verdict ? "" : "; other balls down")};
}

cairo_status_t append(void* text, const unsigned char* bytes, unsigned int count) {
    static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
    return CAIRO_STATUS_SUCCESS;
}

}  // namespace

Result<std::string, PictureError> picture_of(const Scene& scene, const Comparison& comparison,
                                             PictureFormat format) {
    if (!client::has_fonts()) return PictureError{std::string(client::kNoFonts)};
    const Page page(scene, comparison);
    const double height = std::ceil(page.height());
    std::string bytes;
    const std::unique_ptr<cairo_surface_t, CloseCairo> surface(
        format == PictureFormat::kSvg
            ? cairo_svg_surface_create_for_stream(append, &bytes, kPageWidth, height)
            : cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(kPageWidth),
                                         static_cast<int>(height)));
    {
        Drawing drawing(surface.get());
        page.draw(drawing);
    }
    if (format == PictureFormat::kPng)
        cairo_surface_write_to_png_stream(surface.get(), append, &bytes);
    cairo_surface_finish(surface.get());
    const cairo_status_t status = cairo_surface_status(surface.get());
    if (status != CAIRO_STATUS_SUCCESS) return PictureError{cairo_status_to_string(status)};
    return bytes;
}

}  // namespace poolhall::lab
