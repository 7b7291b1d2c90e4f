#include "protocol/text.hpp"

#include "protocol/limits.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <system_error>

namespace poolhall::protocol {
namespace {

constexpr std::size_t kMaxShownBytes = 48;
constexpr std::size_t kMaxTypedCodeBytes = 16;

struct Decoded {
    char32_t code_point = 0;
    std::size_t bytes = 0;  ///< 0: not UTF-8
};

std::size_t sequence_length(std::uint8_t lead) {
    if (lead < 0x80) return 1;
    if (lead >= 0xC2 && lead < 0xE0) return 2;
    if (lead >= 0xE0 && lead < 0xF0) return 3;
    if (lead >= 0xF0 && lead < 0xF5) return 4;
    return 0;
}

/// The first code point of a text that is not empty.
Decoded first_code_point(std::string_view text) {
    const auto lead = static_cast<std::uint8_t>(text[0]);
    const std::size_t length = sequence_length(lead);
    if (length == 0 || length > text.size()) return {};
    if (length == 1) return {lead, 1};
    char32_t code_point = lead & (0xFFU >> (length + 1));
    for (std::size_t i = 1; i < length; ++i) {
        const auto byte = static_cast<std::uint8_t>(text[i]);
        if ((byte & 0xC0U) != 0x80) return {};
        code_point = code_point << 6U | (byte & 0x3FU);
    }
    const bool overlong =
        (length == 3 && code_point < 0x800) || (length == 4 && code_point < 0x10000);
    const bool surrogate = code_point >= 0xD800 && code_point < 0xE000;
    if (overlong || surrogate || code_point > 0x10FFFF) return {};
    return {code_point, length};
}

bool is_control(char32_t c) {
    return c < 0x20 || (c >= 0x7F && c < 0xA0)  // C0, DEL, C1
           || c == 0x2028 || c == 0x2029        // line and paragraph separators
           || (c >= 0x202A && c <= 0x202E)      // embeddings and overrides of direction
           || (c >= 0x2066 && c <= 0x2069)      // isolates
           || c == 0xFEFF;                      // byte order mark
}

bool is_blank(char32_t c) {
    return c == 0x20 || c == 0xA0 || c == 0x3000 || (c >= 0x2000 && c <= 0x200F);
}

/// The bits of hex digits with or without a point, and how many of them stand before it.
struct Bits {
    std::string bits;
    std::size_t before_point = 0;
};

Bits bits_of(std::string_view digits) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    Bits result;
    std::optional<std::size_t> point;
    for (const char c : digits) {
        if (c == '.') {
            point = result.bits.size();
            continue;
        }
        const std::size_t digit = kDigits.find(c >= 'A' && c <= 'F' ? c - 'A' + 'a' : c);
        for (const std::size_t bit : {8U, 4U, 2U, 1U})
            result.bits += (digit & bit) != 0 ? '1' : '0';
    }
    result.before_point = point.value_or(result.bits.size());
    return result;
}

bool is_hex_digit(char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

/// Hex digits, of which there is one at least, and at most one point.
bool are_digits(std::string_view text) {
    const auto points = std::count(text.begin(), text.end(), '.');
    const auto digits = std::count_if(text.begin(), text.end(), is_hex_digit);
    return digits > 0 && points <= 1 && points + digits == std::ssize(text);
}

/// What stands behind the p; nothing if it is no whole number.
std::optional<std::int64_t> exponent_of(std::string_view text) {
    if (text.starts_with("+-")) return std::nullopt;
    if (text.starts_with('+')) text.remove_prefix(1);
    std::int64_t exponent = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, exponent);
    constexpr std::int64_t kFarOut = 1'000'000;
    const bool good = error == std::errc{} && stop == end && std::abs(exponent) <= kFarOut;
    return good ? std::optional(exponent) : std::nullopt;
}

/// The double of these bits, the last of them before the point, times 2^exponent; nothing if no
/// double is that number.
std::optional<double> double_of(const Bits& digits, std::int64_t exponent) {
    constexpr std::size_t kMantissaBits = 53;
    constexpr std::int64_t kLeastExponent = -1074;
    constexpr std::int64_t kLargestExponent = 1023;
    const std::size_t first = digits.bits.find('1');
    if (first == std::string::npos) return 0.0;
    const std::size_t last = digits.bits.rfind('1');
    if (last - first >= kMantissaBits) return std::nullopt;
    const auto power = exponent + static_cast<std::int64_t>(digits.before_point) - 1 -
                       static_cast<std::int64_t>(last);
    const auto top = power + static_cast<std::int64_t>(last - first);
    if (power < kLeastExponent || top > kLargestExponent) return std::nullopt;
    double mantissa = 0;
    for (std::size_t i = first; i <= last; ++i)
        mantissa = 2 * mantissa + (digits.bits[i] == '1' ? 1 : 0);
    return std::ldexp(mantissa, static_cast<int>(power));
}

char upper(char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

}  // namespace

bool is_utf8(std::string_view text) {
    while (!text.empty()) {
        const Decoded next = first_code_point(text);
        if (next.bytes == 0) return false;
        text.remove_prefix(next.bytes);
    }
    return true;
}

std::optional<std::string_view> find_name_fault(std::string_view name) {
    if (name.size() > kMaxNameBytes) return "must be at most 32 bytes of UTF-8";
    bool visible = false;
    while (!name.empty()) {
        const Decoded next = first_code_point(name);
        if (next.bytes == 0) return "must be UTF-8";
        if (is_control(next.code_point)) return "must not have control characters";
        visible = visible || !is_blank(next.code_point);
        name.remove_prefix(next.bytes);
    }
    if (!visible) return "must not be empty";
    return std::nullopt;
}

std::optional<std::string> normalize_code(std::string_view typed) {
    if (typed.size() > kMaxTypedCodeBytes) return std::nullopt;
    std::string code;
    for (const char c : typed) {
        if (c == '-' || c == ' ') continue;
        code += upper(c);
    }
    const bool letters = code.find_first_not_of(kCodeAlphabet) == std::string::npos;
    if (code.size() != kCodeLetters || !letters) return std::nullopt;
    return code;
}

std::string spoken_code(std::string_view code) {
    std::string spoken(code);
    if (code.size() == kCodeLetters) spoken.insert(kCodeLetters / 2, "-");
    return spoken;
}

bool is_token(std::string_view text) {
    return text.size() == kTokenHexDigits &&
           text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

std::optional<double> parse_hex_float(std::string_view text) {
    const bool negative = text.starts_with('-');
    if (negative || text.starts_with('+')) text.remove_prefix(1);
    if (!text.starts_with("0x") && !text.starts_with("0X")) return std::nullopt;
    text.remove_prefix(2);
    // Not by std::from_chars: libc++ has none for doubles.
    const std::size_t mark = std::min(text.find_first_of("pP"), text.size());
    if (!are_digits(text.substr(0, mark))) return std::nullopt;
    const auto exponent =
        mark == text.size() ? std::optional<std::int64_t>(0) : exponent_of(text.substr(mark + 1));
    if (!exponent) return std::nullopt;
    const auto value = double_of(bits_of(text.substr(0, mark)), *exponent);
    return value && negative ? -*value : value;
}

std::string to_hex_float(double number) {
    std::array<char, 32> digits{};
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(),
                                            std::abs(number), std::chars_format::hex);
    assert(error == std::errc{});
    return (std::signbit(number) ? "-0x" : "0x") + std::string(digits.data(), end);
}

std::string shown(std::string_view key) {
    std::string result;
    while (!key.empty()) {
        const Decoded next = first_code_point(key);
        const std::size_t bytes = std::max<std::size_t>(next.bytes, 1);
        if (result.size() + bytes > kMaxShownBytes) return result + "...";
        if (next.bytes == 0 || is_control(next.code_point)) {
            result += '?';
        } else {
            result += key.substr(0, bytes);
        }
        key.remove_prefix(bytes);
    }
    return result;
}

}  // namespace poolhall::protocol
