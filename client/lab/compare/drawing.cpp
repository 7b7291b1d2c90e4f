#include "client/lab/compare/drawing.hpp"

#include <cmath>
#include <numbers>

namespace poolhall::lab {

namespace {

constexpr double kWholeTurn = 2 * std::numbers::pi;

}  // namespace

void Drawing::fill_rectangle(Pixel corner, double width, double height, Colour colour) {
    take(colour);
    cairo_rectangle(cairo_.get(), corner.x, corner.y, width, height);
    cairo_fill(cairo_.get());
}

void Drawing::line(std::span<const Pixel> corners, const Pen& pen) {
    take(pen);
    for (const Pixel corner : corners)
        cairo_line_to(cairo_.get(), corner.x, corner.y);
    cairo_stroke(cairo_.get());
}

void Drawing::ring(Pixel centre, double radius, const Pen& pen) {
    take(pen);
    cairo_new_sub_path(cairo_.get());
    cairo_arc(cairo_.get(), centre.x, centre.y, radius, 0, kWholeTurn);
    cairo_stroke(cairo_.get());
}

void Drawing::disc(Pixel centre, double radius, Colour colour) {
    take(colour);
    cairo_arc(cairo_.get(), centre.x, centre.y, radius, 0, kWholeTurn);
    cairo_fill(cairo_.get());
}

void Drawing::arc(Pixel centre, double radius, double from, double to, const Pen& pen) {
    take(pen);
    const bool clockwise = std::remainder(to - from, kWholeTurn) > 0;
    const auto add = clockwise ? cairo_arc : cairo_arc_negative;
    add(cairo_.get(), centre.x, centre.y, radius, from, to);
    cairo_stroke(cairo_.get());
}

void Drawing::cross(Pixel centre, double size, const Pen& pen) {
    take(pen);
    const double half = size / 2;
    cairo_move_to(cairo_.get(), centre.x - half, centre.y - half);
    cairo_line_to(cairo_.get(), centre.x + half, centre.y + half);
    cairo_move_to(cairo_.get(), centre.x + half, centre.y - half);
    cairo_line_to(cairo_.get(), centre.x - half, centre.y + half);
    cairo_stroke(cairo_.get());
}

void Drawing::text(const std::string& text, const TextFont& font, Pixel at) {
    take(font);
    cairo_move_to(cairo_.get(), at.x, at.y);
    cairo_show_text(cairo_.get(), text.c_str());
    cairo_new_path(cairo_.get());
}

void Drawing::centred_text(const std::string& text, const TextFont& font, Pixel at) {
    this->text(text, font, {at.x - width_of(text, font) / 2, at.y});
}

double Drawing::width_of(const std::string& text, const TextFont& font) {
    take(font);
    cairo_text_extents_t extents{};
    cairo_text_extents(cairo_.get(), text.c_str(), &extents);
    return extents.x_advance;
}

void Drawing::take(const Pen& pen) {
    take(pen.colour);
    cairo_set_line_width(cairo_.get(), pen.width);
    cairo_set_line_join(cairo_.get(), CAIRO_LINE_JOIN_ROUND);
    cairo_set_dash(cairo_.get(), pen.dash.data(), static_cast<int>(pen.dash.size()), 0);
}

void Drawing::take(const TextFont& font) {
    take(font.colour);
    cairo_select_font_face(cairo_.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           font.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo_.get(), font.size);
}

}  // namespace poolhall::lab
