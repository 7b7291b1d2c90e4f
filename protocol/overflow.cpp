#include "protocol/overflow.hpp"

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>

namespace poolhall::protocol {
namespace {

/// Passes over digits; false if there are none.
bool pass_digits(std::string_view& text) {
    const std::size_t count = std::min(text.find_first_not_of("0123456789"), text.size());
    text.remove_prefix(count);
    return count > 0;
}

/// Whether it is a JSON number (RFC 8259, section 6) and nothing more.
bool is_number(std::string_view text) {
    if (text.starts_with('-')) text.remove_prefix(1);
    const bool zero_first = text.starts_with('0');
    const std::size_t before = text.size();
    if (!pass_digits(text) || (zero_first && before - text.size() > 1)) return false;
    if (text.starts_with('.')) {
        text.remove_prefix(1);
        if (!pass_digits(text)) return false;
    }
    if (text.starts_with('e') || text.starts_with('E')) {
        text.remove_prefix(1);
        if (text.starts_with('+') || text.starts_with('-')) text.remove_prefix(1);
        if (!pass_digits(text)) return false;
    }
    return text.empty();
}

/// Whether it is a JSON number beyond the largest double.
bool overflows(std::string_view number) {
    // Of what is a number the parser refuses nothing else.
    return is_number(number) && nlohmann::json::parse(number, nullptr, false).is_discarded();
}

/// One past the string that begins at `at`, or the end of a text that does not end it.
std::size_t end_of_string(std::string_view text, std::size_t at) {
    for (++at; at < text.size() && text[at] != '"'; ++at)
        if (text[at] == '\\') ++at;
    return std::min(at + 1, text.size());
}

}  // namespace

Restated restate(std::string_view json) {
    Restated restated{std::string(json), {}};
    for (std::size_t at = 0; at < json.size();) {
        if (json[at] == '"') {
            at = end_of_string(json, at);
            continue;
        }
        const std::size_t end =
            std::min(json.find_first_not_of("+-.0123456789eE", at), json.size());
        const std::string_view number = json.substr(at, end - at);
        // The shortest such number, 1e309, is longer than null.
        if (number.size() > 4 && overflows(number)) {
            restated.text.replace(at, number.size(), number.size(), ' ');
            restated.text.replace(at, 4, "null");
            restated.lost.push_back(true);
        } else if (json[at] == 'n') {
            restated.lost.push_back(false);
        }
        at = std::max(end, at + 1);
    }
    return restated;
}

}  // namespace poolhall::protocol
