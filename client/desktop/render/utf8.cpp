#include "client/desktop/render/utf8.hpp"

#include <cstdint>

namespace poolhall::client {
namespace {

constexpr std::size_t kMaxCharacters = 512;

std::uint8_t byte_at(std::string_view text, std::size_t i) {
    return static_cast<std::uint8_t>(text[i]);
}

bool continues(std::uint8_t byte) {
    return (byte & 0xC0U) == 0x80;
}

// Length of the well-formed character at the start of the text, 0 if there is none (Unicode 15,
// table 3-7).
std::size_t well_formed(std::string_view text) {
    const std::uint8_t lead = byte_at(text, 0);
    if (lead < 0x80) return 1;
    const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i) {
        if (!continues(byte_at(text, i))) return 0;
    }
    const std::uint8_t second = byte_at(text, 1);
    const bool overlong = (lead == 0xE0 && second < 0xA0) || (lead == 0xF0 && second < 0x90);
    const bool surrogate = lead == 0xED && second > 0x9F;
    const bool beyond = lead == 0xF4 && second > 0x8F;
    return overlong || surrogate || beyond ? 0 : length;
}

bool is_control(std::string_view character) {
    const std::uint8_t first = byte_at(character, 0);
    return first < 0x20 || first == 0x7F || (first == 0xC2 && byte_at(character, 1) < 0xA0);
}

}  // namespace

std::string legible(std::string_view text) {
    std::string result;
    for (std::size_t count = 0; !text.empty() && count < kMaxCharacters; ++count) {
        const std::size_t length = well_formed(text);
        const std::string_view character = text.substr(0, length);
        result += length == 0             ? std::string_view("\xEF\xBF\xBD")
                  : is_control(character) ? std::string_view(" ")
                                          : character;
        text.remove_prefix(length == 0 ? 1 : length);
    }
    return result;
}

std::string_view first_characters(std::string_view text, std::size_t count) {
    std::size_t end = 0;
    while (end < text.size() && count > 0) {
        ++end;
        while (end < text.size() && continues(byte_at(text, end)))
            ++end;
        --count;
    }
    return text.substr(0, end);
}

}  // namespace poolhall::client
