#include "client/desktop/render/text.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace poolhall::client {
namespace {

constexpr int kLeastSize = 6;  // px; less is no letter

double part(Uint8 byte) {
    return byte / 255.0;
}

/// Cairo's pixels have their colours multiplied by alpha, an Image's have not.
std::uint32_t divided_by_alpha(std::uint32_t pixel) {
    const std::uint32_t alpha = pixel >> 24U;
    if (alpha == 0 || alpha == 255) return pixel;
    std::uint32_t result = alpha << 24U;
    for (const unsigned shift : {0U, 8U, 16U}) {
        const std::uint32_t channel = (pixel >> shift) & 255U;
        result |= std::min((channel * 255 + alpha / 2) / alpha, 255U) << shift;
    }
    return result;
}

/// The picture of a box (whole px, seen from the left end of the letters' line).
Image picture_of(const TextLine& line, const SDL_Rect& box, SDL_Color colour) {
    Image image(box.w, box.h);
    cairo_surface_t* surface =
        cairo_image_surface_create_for_data(reinterpret_cast<unsigned char*>(image.pixels.data()),
                                            CAIRO_FORMAT_ARGB32, box.w, box.h, image.pitch());
    cairo_t* cairo = cairo_create(surface);
    cairo_set_source_rgb(cairo, part(colour.r), part(colour.g), part(colour.b));
    line.draw(cairo, -box.x, -box.y);
    cairo_destroy(cairo);
    cairo_surface_destroy(surface);
    std::transform(image.pixels.begin(), image.pixels.end(), image.pixels.begin(),
                   divided_by_alpha);
    return image;
}

/// What is inked in whole pixels, one more all round for soft edges.
SDL_Rect whole_pixels(const TextBox& ink) {
    const auto floor = [](double v) { return static_cast<int>(std::floor(v)); };
    const auto ceil = [](double v) { return static_cast<int>(std::ceil(v)); };
    const int left = floor(ink.x) - 1;
    const int top = floor(ink.y) - 1;
    return {left, top, ceil(ink.x + ink.width) + 1 - left, ceil(ink.y + ink.height) + 1 - top};
}

}  // namespace

Text::Text(Canvas& canvas) : canvas_(canvas) {
    if (!has_fonts()) throw std::runtime_error(std::string(kNoFonts));
}

float Text::draw(std::string_view text, const TextStyle& style, const TextPlace& place) {
    Line* shown = &line(text, style, TextPlace::kEndless);
    if (shown->width > place.max_width) shown = &line(text, style, place.max_width);
    if (!shown->texture) paint(*shown, style.colour);
    if (!shown->texture) return shown->width;
    const float shift = place.align == Align::kLeft ? 0 : place.align == Align::kCentre ? 0.5F : 1;
    const auto height = static_cast<float>(shown->set.height());
    const SDL_FRect& inked = shown->inked;
    const SDL_FRect target{std::round(place.x - shift * shown->width) + inked.x,
                           std::round(place.y - height / 2) + inked.y, inked.w, inked.h};
    SDL_SetTextureAlphaMod(shown->texture.get(), style.colour.a);
    canvas_.copy(shown->texture.get(), target);
    return shown->width;
}

float Text::width(std::string_view text, const TextStyle& style) {
    return line(text, style, TextPlace::kEndless).width;
}

void Text::reset() {
    lines_.clear();
}

Text::Line& Text::line(std::string_view text, const TextStyle& style, float limit) {
    const int size = std::max(static_cast<int>(std::lround(style.size)), kLeastSize);
    const int most = static_cast<int>(std::clamp(limit, 0.0F, TextPlace::kEndless));
    const auto& [r, g, b, a] = style.colour;
    const Key key{std::string(text), size, most, {r, g, b}, style.bold};
    auto found = lines_.find(key);
    if (found == lines_.end()) {
        if (lines_.size() >= kMaxLines) drop_oldest_line();
        const Font font{static_cast<double>(size), style.bold};
        found = lines_.emplace(key, Line(TextLine(text, font, most))).first;
    }
    found->second.last_use = ++uses_;
    return found->second;
}

void Text::paint(Line& line, SDL_Color colour) {
    const TextBox ink = line.set.ink();
    if (ink.width <= 0 || ink.height <= 0) return;
    const SDL_Rect box = whole_pixels(ink);
    line.texture = canvas_.texture_of(picture_of(line.set, box, colour));
    const double base = std::round(line.set.ascent());
    line.inked = {static_cast<float>(box.x), static_cast<float>(box.y + base),
                  static_cast<float>(box.w), static_cast<float>(box.h)};
}

void Text::drop_oldest_line() {
    lines_.erase(std::min_element(lines_.begin(), lines_.end(), [](const auto& a, const auto& b) {
        return a.second.last_use < b.second.last_use;
    }));
}

}  // namespace poolhall::client
