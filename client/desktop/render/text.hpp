#pragma once

#include "client/desktop/render/canvas.hpp"
#include "client/text/text_line.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>

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
    float max_width = kEndless;  ///< px; longer text ends in an ellipsis

    static constexpr float kEndless = 16384;  ///< px; no texture is wider
};

/// Lines of text (TextLine) on the canvas. Any bytes may be given as text.
class Text {
  public:
    /// Throws std::runtime_error, one line, where there is no font. The canvas must outlive the
    /// text.
    explicit Text(Canvas& canvas);

    /// Draws one line and returns its width, px.
    float draw(std::string_view text, const TextStyle& style, const TextPlace& place);
    [[nodiscard]] float width(std::string_view text, const TextStyle& style);
    /// The device has lost its textures.
    void reset();

    /// Lines kept; bounded by kMaxLines.
    [[nodiscard]] std::size_t cached_lines() const { return lines_.size(); }

    static constexpr std::size_t kMaxLines = 256;

  private:
    struct Key {
        std::string text;
        int size = 0;   ///< px
        int limit = 0;  ///< px that it may be wide
        /// Red, green and blue: letters have them already in the texture, so emoji keep theirs.
        std::array<Uint8, 3> colour{};
        bool bold = false;
        auto operator<=>(const Key&) const = default;
    };

    struct Line {
        explicit Line(TextLine of) : set(std::move(of)) {}

        TextLine set;
        float width = static_cast<float>(std::ceil(set.width()));
        TexturePtr texture;  ///< of what is inked, from the first time that it is drawn
        SDL_FRect inked{};   ///< seen from the left end of the line's middle, px
        std::uint64_t last_use = 0;
    };

    [[nodiscard]] Line& line(std::string_view text, const TextStyle& style, float limit);
    void paint(Line& line, SDL_Color colour);
    void drop_oldest_line();

    Canvas& canvas_;
    std::map<Key, Line> lines_;
    std::uint64_t uses_ = 0;
};

}  // namespace poolhall::client
