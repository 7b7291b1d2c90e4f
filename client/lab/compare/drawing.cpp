#include "client/lab/compare/drawing.hpp"

#include "client/text/text_line.hpp"

#include <cmath>
#include <numbers>

namespace poolhall::lab {

namespace {

constexpr double kWholeTurn = 2 * std::numbers::pi;

client::TextLine set(const std::string& text, const TextFont& font) {
    return {text, {font.size, font.bold}};
}

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
    take(font.colour);
    set(text, font).draw(cairo_.get(), at.x, at.y);
}

void Drawing::centred_text(const std::string& text, const TextFont& font, Pixel at) {
    this->text(text, font, {at.x - width_of(text, font) / 2, at.y});
}

double Drawing::width_of(const std::string& text, const TextFont& font) {
    return set(text, font).width();
}

void Drawing::take(const Pen& pen) {
    take(pen.colour);
    cairo_set_line_width(cairo_.get(), pen.width);
    cairo_set_line_join(cairo_.get(), CAIRO_LINE_JOIN_ROUND);
    cairo_set_dash(cairo_.get(), pen.dash.data(), static_cast<int>(pen.dash.size()), 0);
}

}  // namespace poolhall::lab
