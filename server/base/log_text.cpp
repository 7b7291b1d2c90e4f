#include "server/base/log_text.hpp"

namespace poolhall::server {

std::string in_quotes(std::string_view text) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string line = "\"";
    for (const char character : text) {
        const auto byte = static_cast<unsigned char>(character);
        if (character == '"' || character == '\\') {
            line += '\\';
            line += character;
        } else if (byte >= 0x20 && byte < 0x7f) {
            line += character;
        } else {
            line += "\\x";
            line += kDigits[byte >> 4U];
            line += kDigits[byte & 15U];
        }
    }
    return line + '"';
}

}  // namespace poolhall::server
