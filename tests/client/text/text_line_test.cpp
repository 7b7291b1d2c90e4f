#include "client/text/text_line.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <pango/pangocairo.h>
#include <string>
#include <vector>

namespace poolhall::client {
namespace {

constexpr Font kFont{32, false};
constexpr const char* kReplacement = "\xEF\xBF\xBD";

double width(std::string_view text) {
    return TextLine(text, kFont).width();
}

/// White text on nothing, its letters on line 64 of 128.
class Inked {
  public:
    static constexpr int kSide = 128;

    explicit Inked(std::string_view text) {
        cairo_surface_t* surface =
            cairo_image_surface_create_for_data(reinterpret_cast<unsigned char*>(pixels_.data()),
                                                CAIRO_FORMAT_ARGB32, kSide, kSide, 4 * kSide);
        cairo_t* cairo = cairo_create(surface);
        cairo_set_source_rgb(cairo, 1, 1, 1);
        TextLine(text, kFont).draw(cairo, 0, kSide / 2);
        cairo_destroy(cairo);
        cairo_surface_destroy(surface);
    }

    [[nodiscard]] std::vector<std::uint32_t> columns(int from, int to) const {
        std::vector<std::uint32_t> result;
        for (int y = 0; y < kSide; ++y)
            result.insert(result.end(), pixels_.begin() + y * kSide + from,
                          pixels_.begin() + y * kSide + to);
        return result;
    }

    [[nodiscard]] bool has_colour() const {
        return std::any_of(pixels_.begin(), pixels_.end(), [](std::uint32_t pixel) {
            const int red = static_cast<int>((pixel >> 16U) & 255U);
            const int blue = static_cast<int>(pixel & 255U);
            return std::abs(red - blue) > 60;
        });
    }

  private:
    std::vector<std::uint32_t> pixels_ = std::vector<std::uint32_t>(kSide * kSide);
};

TEST(TextLine, ArabicLettersAreJoined) {
    const double joined = width("بب");
    EXPECT_LT(joined, 2 * width("ب") - 2);
    EXPECT_LT(joined, width("ب\u200Cب") - 2) << "kept apart by a zero width non-joiner";
}

TEST(TextLine, HebrewRunsFromRightToLeft) {
    const int narrow = static_cast<int>(std::floor(width("ו")));
    const Inked word("שו");
    EXPECT_EQ(word.columns(0, narrow), Inked("ו").columns(0, narrow)) << "its last letter is left";
    EXPECT_NE(word.columns(0, narrow), Inked("ש").columns(0, narrow));
}

TEST(TextLine, SentenceKeepsItsOrderWhoeverItBeginsWith) {
    // "IS AIMING" right of the name, not left of it.
    const int name = static_cast<int>(std::floor(width("שו")));
    EXPECT_EQ(Inked("שו is").columns(0, name), Inked("שו").columns(0, name));
}

TEST(TextLine, FontsThatSetupInstallsHaveEveryScript) {
    for (const char* name :
         {"محمد",  "שרה",  "王小明", "さくら", "ユミ",   "김철수", "สมชาย",
          "प्रिया", "রহিম", "அன்பு",   "გიორგი", "Արամ",   "ኣበበ",    "សុខា",
          "မောင်",  "བསོད",  "Ольга",  "Ελένη",  "Nguyễn", "🎱",      "👩‍🚀"}) {
        PangoContext* context = pango_font_map_create_context(pango_cairo_font_map_get_default());
        PangoLayout* layout = pango_layout_new(context);
        pango_layout_set_text(layout, name, -1);
        EXPECT_EQ(pango_layout_get_unknown_glyphs_count(layout), 0) << name;
        g_object_unref(layout);
        g_object_unref(context);
    }
}

TEST(TextLine, EmojiKeepTheirOwnColours) {
    EXPECT_TRUE(Inked("🍎").has_colour());
    EXPECT_FALSE(Inked("Ada").has_colour());
}

TEST(TextLine, LinesOfSeveralScriptsStandLevel) {
    const TextLine latin("Ada", kFont);
    for (const char* name : {"王小明", "สมชาย", "محمد", "🎱", ""}) {
        EXPECT_EQ(TextLine(name, kFont).ascent(), latin.ascent()) << name;
        EXPECT_EQ(TextLine(name, kFont).height(), latin.height()) << name;
    }
}

TEST(TextLine, TooLongALineEndsInAnEllipsis) {
    const double room = width("Maximiliane");
    const TextLine cut("Maximiliane von und zu Hohenstein", kFont, room);
    EXPECT_LE(cut.width(), room);
    EXPECT_GT(cut.width(), room / 2);
    EXPECT_EQ(TextLine("Ada", kFont, width("Ada")).width(), width("Ada"));
    EXPECT_EQ(TextLine("Maximiliane", kFont, 1).width(), 0) << "no room for an ellipsis";
    EXPECT_EQ(TextLine("Maximiliane", kFont, -5).width(), 0);
    const TextLine arabic("محمد العربي محمد العربي محمد العربي", kFont, room);
    EXPECT_LE(arabic.width(), room);
    EXPECT_GT(arabic.width(), room / 2);
}

TEST(TextLine, IllFormedBytesAreShownAsReplaced) {
    const std::string one = kReplacement;
    EXPECT_EQ(width("a\xFF"), width("a" + one));
    EXPECT_EQ(width("\xC3"), width(one)) << "cut short";
    EXPECT_EQ(width("\xC0\xAF"), width(one + one)) << "overlong";
    EXPECT_EQ(width("\xF4\x90\x80\x80"), width(one + one + one + one)) << "beyond U+10FFFF";
}

TEST(TextLine, ControlCharactersAreBlanks) {
    EXPECT_EQ(width(std::string_view("a\0b\nc\x7F\xC2\x85|", 9)), width("a b c  |"));
    EXPECT_EQ(width("a\u2028b\u2029c"), width("a b c"));
}

TEST(TextLine, EndlessTextIsCut) {
    EXPECT_EQ(width(std::string(100000, 'x')), width(std::string(TextLine::kMaxCharacters, 'x')));
}

TEST(TextLine, BlankTextHasNoInk) {
    EXPECT_EQ(TextLine("", kFont).ink().width, 0);
    EXPECT_EQ(TextLine("  ", kFont).ink().width, 0);
    EXPECT_GT(TextLine("8", kFont).ink().height, 10);
}

}  // namespace
}  // namespace poolhall::client
