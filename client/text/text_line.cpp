#include "client/text/text_line.hpp"

#include <algorithm>
#include <pango/pangocairo.h>
#include <string>

namespace poolhall::client {
namespace {

constexpr const char* kFamily = "DejaVu Sans";

struct Unreference {
    void operator()(void* object) const { g_object_unref(object); }
};

struct FreeDescription {
    void operator()(PangoFontDescription* font) const { pango_font_description_free(font); }
};

struct FreeText {
    void operator()(char* text) const { g_free(text); }
};

using Description = std::unique_ptr<PangoFontDescription, FreeDescription>;
using Context = std::unique_ptr<PangoContext, Unreference>;

double to_pixels(int pango_units) {
    return static_cast<double>(pango_units) / PANGO_SCALE;
}

// The same picture everywhere: nothing of it is left to the desktop's settings.
Context make_context() {
    Context context(pango_font_map_create_context(pango_cairo_font_map_get_default()));
    cairo_font_options_t* options = cairo_font_options_create();
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_MEDIUM);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_ON);
    pango_cairo_context_set_font_options(context.get(), options);
    cairo_font_options_destroy(options);
    pango_context_set_round_glyph_positions(context.get(), TRUE);
    pango_context_set_base_dir(context.get(), PANGO_DIRECTION_LTR);
    pango_context_set_language(context.get(), pango_language_from_string("en"));
    return context;
}

PangoContext* context() {
    thread_local const Context kept = make_context();
    return kept.get();
}

Description description_of(const Font& font) {
    Description description(pango_font_description_new());
    pango_font_description_set_family_static(description.get(), kFamily);
    pango_font_description_set_absolute_size(description.get(), font.size * PANGO_SCALE);
    if (font.bold) pango_font_description_set_weight(description.get(), PANGO_WEIGHT_BOLD);
    return description;
}

std::string legible(std::string_view text) {
    // No character is longer than four bytes: what is cut off here is beyond the last that is kept.
    std::string near(text.substr(0, 4 * TextLine::kMaxCharacters));
    std::replace(near.begin(), near.end(), '\0', ' ');
    const std::unique_ptr<char, FreeText> valid(
        g_utf8_make_valid(near.data(), static_cast<gssize>(near.size())));
    std::string result;
    long count = 0;
    for (const char* at = valid.get(); *at != 0 && count < TextLine::kMaxCharacters; ++count) {
        const char* next = g_utf8_next_char(at);
        const gunichar character = g_utf8_get_char(at);
        // The separators of lines and paragraphs would be drawn as marks.
        const bool blank =
            g_unichar_iscntrl(character) || character == 0x2028 || character == 0x2029;
        result += blank ? std::string_view(" ")
                        : std::string_view(at, static_cast<std::size_t>(next - at));
        at = next;
    }
    return result;
}

}  // namespace

bool has_fonts() {
    const std::unique_ptr<PangoLayout, Unreference> layout(pango_layout_new(context()));
    const Description description = description_of({});
    pango_layout_set_font_description(layout.get(), description.get());
    pango_layout_set_text(layout.get(), "A", 1);
    return pango_layout_get_unknown_glyphs_count(layout.get()) == 0;
}

void TextLine::Release::operator()(PangoLayout* layout) const {
    g_object_unref(layout);
}

TextLine::TextLine(std::string_view text, const Font& font, double max_width)
    : layout_(pango_layout_new(context())) {
    const Description description = description_of(font);
    pango_layout_set_font_description(layout_.get(), description.get());
    pango_layout_set_auto_dir(layout_.get(), FALSE);
    pango_layout_set_single_paragraph_mode(layout_.get(), TRUE);
    const std::string shown = legible(text);
    pango_layout_set_text(layout_.get(), shown.data(), static_cast<int>(shown.size()));
    PangoFontMetrics* metrics = pango_context_get_metrics(context(), description.get(), nullptr);
    ascent_ = to_pixels(pango_font_metrics_get_ascent(metrics));
    height_ = ascent_ + to_pixels(pango_font_metrics_get_descent(metrics));
    pango_font_metrics_unref(metrics);
    const double limit = std::clamp(max_width, 0.0, 1e6);
    if (width() <= limit) return;
    pango_layout_set_ellipsize(layout_.get(), PANGO_ELLIPSIZE_END);
    pango_layout_set_width(layout_.get(), static_cast<int>(limit * PANGO_SCALE));
    if (width() > limit) pango_layout_set_text(layout_.get(), "", 0);
}

double TextLine::width() const {
    PangoRectangle logical;
    pango_layout_line_get_extents(pango_layout_get_line_readonly(layout_.get(), 0), nullptr,
                                  &logical);
    return to_pixels(logical.width);
}

TextBox TextLine::ink() const {
    PangoRectangle ink;
    pango_layout_line_get_extents(pango_layout_get_line_readonly(layout_.get(), 0), &ink, nullptr);
    return {to_pixels(ink.x), to_pixels(ink.y), to_pixels(ink.width), to_pixels(ink.height)};
}

void TextLine::draw(cairo_t* cairo, double x, double y) const {
    cairo_move_to(cairo, x, y);
    pango_cairo_show_layout_line(cairo, pango_layout_get_line_readonly(layout_.get(), 0));
    cairo_new_path(cairo);
}

}  // namespace poolhall::client

#ifdef __SANITIZE_ADDRESS__
// What fontconfig has found it keeps until the process ends, out of the leak sanitizer's sight.
extern "C" const char* __lsan_default_suppressions();

const char* __lsan_default_suppressions() {
    return "leak:libfontconfig\n";
}
#endif
