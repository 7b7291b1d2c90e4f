#pragma once

#include <cairo.h>
#include <memory>
#include <string_view>

using PangoLayout = struct _PangoLayout;

namespace poolhall::client {

struct Font {
    double size = 16;  ///< of the em, px
    bool bold = false;
};

/// A rectangle in px, y downwards.
struct TextBox {
    double x = 0;
    double y = 0;
    double width = 0;
    double height = 0;
};

/// Whether fontconfig finds a font with Latin letters. Without one every line is a row of boxes.
[[nodiscard]] bool has_fonts();

/// What to say where it does not.
inline constexpr std::string_view kNoFonts =
    "no font: fontconfig finds none (Debian: install fonts-dejavu-core)";

/// One line of text as Pango sets it: letters joined and in their script's direction, each by the
/// first font that has it, DejaVu Sans before all others. Any bytes may be given as text: what is
/// no UTF-8 becomes U+FFFD, control characters become blanks, and no more than kMaxCharacters are
/// kept. The line as a whole runs from left to right, as the sentences of this program do; a name
/// from elsewhere goes into one by isolated().
class TextLine {
  public:
    static constexpr long kMaxCharacters = 512;

    /// Text wider than `max_width` px ends in an ellipsis, and in nothing where that has no room.
    TextLine(std::string_view text, const Font& font, double max_width = 1e6);

    /// How far it moves on, px.
    [[nodiscard]] double width() const;

    /// From the top of the font's lines down to where the letters stand, px. It is DejaVu Sans's
    /// whatever letters there are, so lines of several scripts stand level.
    [[nodiscard]] double ascent() const { return ascent_; }

    /// Of the font's lines, px.
    [[nodiscard]] double height() const { return height_; }

    /// What is inked, seen from the left end of the line that the letters stand on; empty for
    /// blanks.
    [[nodiscard]] TextBox ink() const;
    /// Draws it in the source colour of `cairo`; the letters stand on (x, y). Emoji keep their own
    /// colours.
    void draw(cairo_t* cairo, double x, double y) const;

  private:
    struct Release {
        void operator()(PangoLayout* layout) const;
    };

    std::unique_ptr<PangoLayout, Release> layout_;
    double ascent_ = 0;
    double height_ = 0;
};

}  // namespace poolhall::client
