#include "client/desktop/render/text.hpp"

#include "client/desktop/render/utf8.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <stdexcept>

namespace poolhall::client {
namespace {

constexpr std::string_view kRegular = "DejaVuSans.ttf";
constexpr std::string_view kBold = "DejaVuSans-Bold.ttf";
constexpr std::array<std::string_view, 5> kFolders{
    "/usr/share/fonts/truetype/dejavu",  // Debian
    "/usr/share/fonts/dejavu-sans-fonts",
    "/usr/share/fonts/dejavu",
    "/usr/share/fonts/TTF",
    "/usr/local/share/fonts",
};
constexpr std::string_view kEllipsis = "\xE2\x80\xA6";

std::string find_fonts() {
    for (const std::string_view folder : kFolders) {
        std::error_code unreadable;  // as good as not there
        const std::filesystem::path path(folder);
        if (std::filesystem::exists(path / kRegular, unreadable) &&
            std::filesystem::exists(path / kBold, unreadable))
            return path.string();
    }
    throw std::runtime_error(
        "no font: neither " + std::string(kFolders[0]) + "/" + std::string(kRegular) +
        " nor another usual folder has DejaVu Sans (Debian: install fonts-dejavu-core)");
}

std::string elided(TTF_Font* font, const std::string& text, float max_width) {
    const int limit = static_cast<int>(std::clamp(max_width, 0.0F, 16384.0F));
    int width = 0;
    if (TTF_SizeUTF8(font, text.c_str(), &width, nullptr) != 0 || width <= limit) return text;
    int ellipsis = 0;
    TTF_SizeUTF8(font, std::string(kEllipsis).c_str(), &ellipsis, nullptr);
    int fitting = 0;
    int count = 0;
    if (ellipsis > limit ||
        TTF_MeasureUTF8(font, text.c_str(), limit - ellipsis, &fitting, &count) != 0)
        return {};
    return std::string(first_characters(text, static_cast<std::size_t>(std::max(count, 0)))) +
           std::string(kEllipsis);
}

}  // namespace

Text::Library::Library() {
    if (TTF_Init() != 0) throw std::runtime_error(std::string("no fonts: ") + TTF_GetError());
}

Text::Library::~Library() {
    TTF_Quit();
}

Text::Text(Canvas& canvas) : canvas_(canvas), folder_(find_fonts()) {
    if (font({false, 16}) == nullptr || font({true, 16}) == nullptr)
        throw std::runtime_error("no font: " + std::string(TTF_GetError()));
}

float Text::draw(std::string_view text, const TextStyle& style, const TextPlace& place) {
    const FontKey key{style.bold, std::max(static_cast<int>(std::lround(style.size)), 6)};
    TTF_Font* face = font(key);
    if (face == nullptr) return 0;
    const Line& shown = line({key, elided(face, legible(text), place.max_width)});
    if (!shown.texture) return 0;
    const float shift = place.align == Align::kLeft ? 0 : place.align == Align::kCentre ? 0.5F : 1;
    const SDL_FRect target{std::round(place.x - shift * shown.width),
                           std::round(place.y - shown.height / 2), shown.width, shown.height};
    SDL_SetTextureColorMod(shown.texture.get(), style.colour.r, style.colour.g, style.colour.b);
    SDL_SetTextureAlphaMod(shown.texture.get(), style.colour.a);
    canvas_.copy(shown.texture.get(), target);
    return shown.width;
}

float Text::width(std::string_view text, const TextStyle& style) {
    int width = 0;
    TTF_Font* face = font({style.bold, std::max(static_cast<int>(std::lround(style.size)), 6)});
    if (face != nullptr) TTF_SizeUTF8(face, legible(text).c_str(), &width, nullptr);
    return static_cast<float>(width);
}

void Text::reset() {
    lines_.clear();
}

TTF_Font* Text::font(const FontKey& key) {
    if (const auto found = fonts_.find(key); found != fonts_.end()) return found->second.get();
    if (fonts_.size() >= kMaxFonts) fonts_.clear();
    const std::string path = folder_ + "/" + std::string(key.bold ? kBold : kRegular);
    TTF_Font* opened = TTF_OpenFont(path.c_str(), key.size);
    if (opened != nullptr) fonts_[key].reset(opened);
    return opened;
}

Text::Line& Text::line(const LineKey& key) {
    auto found = lines_.find(key);
    if (found == lines_.end()) {
        if (lines_.size() >= kMaxLines) drop_oldest_line();
        found = lines_.emplace(key, render(key)).first;
    }
    found->second.last_use = ++uses_;
    return found->second;
}

Text::Line Text::render(const LineKey& key) {
    Line result;
    if (key.text.empty()) return result;
    const SurfacePtr surface(
        TTF_RenderUTF8_Blended(font(key.font), key.text.c_str(), {255, 255, 255, 255}));
    if (!surface) return result;
    result.texture.reset(SDL_CreateTextureFromSurface(canvas_.renderer(), surface.get()));
    result.width = static_cast<float>(surface->w);
    result.height = static_cast<float>(surface->h);
    return result;
}

void Text::drop_oldest_line() {
    lines_.erase(std::min_element(lines_.begin(), lines_.end(), [](const auto& a, const auto& b) {
        return a.second.last_use < b.second.last_use;
    }));
}

}  // namespace poolhall::client
