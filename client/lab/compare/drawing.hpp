#pragma once

#include "shared/math/vec2.hpp"

#include <cairo.h>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace poolhall::lab {

/// 0 to 1 each.
struct Colour {
    double r = 0;
    double g = 0;
    double b = 0;
};

struct Pen {
    Colour colour;
    double width = 1;               ///< px
    std::vector<double> dash = {};  ///< lengths of dashes and gaps, px; none: solid
};

struct Pixel {
    double x = 0;
    double y = 0;  ///< downwards
};

struct TextFont {
    double size = 24;  ///< px
    Colour colour;
    bool bold = false;
};

struct CloseCairo {
    void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }

    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};

/// Lines, discs and text on a surface of cairo's, in px.
class Drawing {
  public:
    /// The surface must outlive the drawing.
    explicit Drawing(cairo_surface_t* surface) : cairo_(cairo_create(surface)) {}

    void fill_rectangle(Pixel corner, double width, double height, Colour colour);
    void line(std::span<const Pixel> corners, const Pen& pen);
    void ring(Pixel centre, double radius, const Pen& pen);
    void disc(Pixel centre, double radius, Colour colour);
    /// The shorter way round from one angle to the other, in radians, clockwise on the page.
    void arc(Pixel centre, double radius, double from, double to, const Pen& pen);
    void cross(Pixel centre, double size, const Pen& pen);

    /// `at` is the left end of the line's base.
    void text(const std::string& text, const TextFont& font, Pixel at);
    void centred_text(const std::string& text, const TextFont& font, Pixel at);
    /// px.
    [[nodiscard]] static double width_of(const std::string& text, const TextFont& font);

  private:
    void take(const Pen& pen);

    void take(Colour colour) { cairo_set_source_rgb(cairo_.get(), colour.r, colour.g, colour.b); }

    std::unique_ptr<cairo_t, CloseCairo> cairo_;
};

}  // namespace poolhall::lab
