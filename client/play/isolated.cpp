#include "client/play/isolated.hpp"

#include <algorithm>

namespace poolhall::client {
namespace {

constexpr std::string_view kFirstStrongIsolate = "\xE2\x81\xA8";
constexpr std::string_view kPopDirectionalIsolate = "\xE2\x81\xA9";

/// U+202A to U+202E and U+2066 to U+2069: embeddings, overrides and isolates, and their ends.
bool is_mark_of_direction(std::string_view three_bytes) {
    return (three_bytes >= "\xE2\x80\xAA" && three_bytes <= "\xE2\x80\xAE") ||
           (three_bytes >= "\xE2\x81\xA6" && three_bytes <= "\xE2\x81\xA9");
}

bool is_ascii(char byte) {
    return static_cast<unsigned char>(byte) < 0x80;
}

}  // namespace

std::string isolated(std::string_view name) {
    if (std::all_of(name.begin(), name.end(), is_ascii)) return std::string(name);
    std::string result(kFirstStrongIsolate);
    for (std::size_t i = 0; i < name.size(); ++i) {
        const std::string_view three = name.substr(i, 3);
        if (three.size() == 3 && is_mark_of_direction(three))
            i += 2;
        else
            result += name[i];
    }
    return result.append(kPopDirectionalIsolate);
}

}  // namespace poolhall::client
