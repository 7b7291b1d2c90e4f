#pragma once

#include "client/desktop/render/canvas.hpp"

#include <SDL2/SDL_ttf.h>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace poolhall::client {

struct TextStyle {
    float size = 16;  ///< px
    SDL_Color colour{255, 255, 255, 255};
    bool bold = false;
};

/// Which point of the text's line is placed.
enum class Align : std::uint8_t { kLeft, kCentre, kRight };

/// Where a line of text goes: `y` is the middle of its height.
struct TextPlace {
    float x = 0;
    float y = 0;
    Align align = Align::kLeft;
    float max_width = 1e6F;  ///< px; longer text ends in an ellipsis
};

/// Lines of text in DejaVu Sans. Any bytes may be given as text.
class Text {
  public:
    /// Throws std::runtime_error, one line, where the fonts cannot be found. The canvas must
    /// outlive the text.
    explicit Text(Canvas& canvas);

    /// Draws one line and returns its width, px.
    float draw(std::string_view text, const TextStyle& style, const TextPlace& place);
    [[nodiscard]] float width(std::string_view text, const TextStyle& style);
    /// The device has lost its textures.
    void reset();

    /// Lines kept as textures; bounded by kMaxLines.
    [[nodiscard]] std::size_t cached_lines() const { return lines_.size(); }

    static constexpr std::size_t kMaxLines = 256;
    static constexpr std::size_t kMaxFonts = 24;

  private:
    struct Library {
        Library();
        ~Library();
        Library(const Library&) = delete;
        Library& operator=(const Library&) = delete;
    };

    struct CloseFont {
        void operator()(TTF_Font* font) const { TTF_CloseFont(font); }
    };

    struct FontKey {
        bool bold = false;
        int size = 0;  ///< px
        auto operator<=>(const FontKey&) const = default;
    };

    struct LineKey {
        FontKey font;
        std::string text;
        auto operator<=>(const LineKey&) const = default;
    };

    /// Null texture: nothing to see.
    struct Line {
        TexturePtr texture;
        float width = 0;
        float height = 0;
        std::uint64_t last_use = 0;
    };

    [[nodiscard]] TTF_Font* font(const FontKey& key);
    [[nodiscard]] Line& line(const LineKey& key);
    [[nodiscard]] Line render(const LineKey& key);
    void drop_oldest_line();

    Library library_;
    Canvas& canvas_;
    std::string folder_;
    std::map<FontKey, std::unique_ptr<TTF_Font, CloseFont>> fonts_;
    std::map<LineKey, Line> lines_;
    std::uint64_t uses_ = 0;
};

}  // namespace poolhall::client
