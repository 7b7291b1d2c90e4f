#include "protocol/intake/person_name.hpp"

#include "protocol/limits.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <initializer_list>
#include <memory>
#include <new>
#include <optional>
#include <utf8proc.h>
#include <vector>

namespace poolhall::protocol {
namespace {

using CodePoint = utf8proc_int32_t;

constexpr CodePoint kNonJoiner = 0x200C;
constexpr CodePoint kJoiner = 0x200D;
/// Of Braille and of musical notation: symbols by their category, blank by their name.
constexpr std::array<CodePoint, 2> kBlankSymbols{0x2800, 0x1D159};
/// The canonical combining class of the signs that suppress a vowel.
constexpr utf8proc_propval_t kVirama = 9;

bool has_category(CodePoint c, std::initializer_list<utf8proc_category_t> categories) {
    const utf8proc_category_t own = utf8proc_category(c);
    return std::find(categories.begin(), categories.end(), own) != categories.end();
}

/// Unicode's White_Space.
bool is_white_space(CodePoint c) {
    return (c >= 0x09 && c <= 0x0D) || c == 0x85 ||
           has_category(c, {UTF8PROC_CATEGORY_ZS, UTF8PROC_CATEGORY_ZL, UTF8PROC_CATEGORY_ZP});
}

bool is_blank(CodePoint c) {
    return utf8proc_category(c) == UTF8PROC_CATEGORY_ZS ||
           std::find(kBlankSymbols.begin(), kBlankSymbols.end(), c) != kBlankSymbols.end();
}

bool is_ignorable(CodePoint c) {
    return utf8proc_get_property(c)->ignorable != 0 || utf8proc_category(c) == UTF8PROC_CATEGORY_CF;
}

bool is_mark(CodePoint c) {
    return has_category(c, {UTF8PROC_CATEGORY_MN, UTF8PROC_CATEGORY_MC, UTF8PROC_CATEGORY_ME});
}

/// Embeddings, overrides and isolates of direction, and their ends.
bool turns_direction(CodePoint c) {
    switch (utf8proc_get_property(c)->bidi_class) {
        case UTF8PROC_BIDI_CLASS_LRE:
        case UTF8PROC_BIDI_CLASS_RLE:
        case UTF8PROC_BIDI_CLASS_LRO:
        case UTF8PROC_BIDI_CLASS_RLO:
        case UTF8PROC_BIDI_CLASS_PDF:
        case UTF8PROC_BIDI_CLASS_LRI:
        case UTF8PROC_BIDI_CLASS_RLI:
        case UTF8PROC_BIDI_CLASS_FSI:
        case UTF8PROC_BIDI_CLASS_PDI:
            return true;
        default:
            return false;
    }
}

bool is_arabic(CodePoint c) {
    return utf8proc_get_property(c)->bidi_class == UTF8PROC_BIDI_CLASS_AL;
}

/// Whether a joiner shapes the letters beside it, much as RFC 5892, appendices A.1 and A.2, has it.
bool shapes(CodePoint joiner, CodePoint before, CodePoint after) {
    if (is_blank(after) || is_ignorable(after)) return false;
    if (utf8proc_get_property(before)->combining_class == kVirama) return true;
    return joiner == kNonJoiner && is_arabic(before) && is_arabic(after);
}

std::optional<NameFault> fault_of(CodePoint c) {
    if (turns_direction(c) ||
        has_category(c, {UTF8PROC_CATEGORY_CC, UTF8PROC_CATEGORY_ZL, UTF8PROC_CATEGORY_ZP}))
        return NameFault{"must not have control characters"};
    // Some unassigned ones are ignorable, for what they may become.
    if (has_category(c, {UTF8PROC_CATEGORY_CN, UTF8PROC_CATEGORY_CO, UTF8PROC_CATEGORY_CS}))
        return NameFault{"must not have characters that are unassigned or for private use"};
    return std::nullopt;
}

std::optional<std::vector<CodePoint>> decode(std::string_view text) {
    std::vector<CodePoint> result;
    while (!text.empty()) {
        CodePoint c = 0;
        // utf8proc takes bytes as unsigned char.
        const auto* bytes = reinterpret_cast<const utf8proc_uint8_t*>(text.data());
        const auto size = utf8proc_iterate(bytes, static_cast<utf8proc_ssize_t>(text.size()), &c);
        if (size <= 0) return std::nullopt;
        result.push_back(c);
        text.remove_prefix(static_cast<std::size_t>(size));
    }
    return result;
}

void trim(std::vector<CodePoint>& text) {
    const auto stays = [](CodePoint c) {
        return !is_white_space(c) && (!is_ignorable(c) || fault_of(c));
    };
    text.erase(std::find_if(text.rbegin(), text.rend(), stays).base(), text.end());
    text.erase(text.begin(), std::find_if(text.begin(), text.end(), stays));
}

/// What is to be seen of the text, each run of blanks as one space.
Result<std::vector<CodePoint>, NameFault> visible_part(const std::vector<CodePoint>& text) {
    std::vector<CodePoint> result;
    bool blank = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const CodePoint c = text[i];
        if (const auto fault = fault_of(c)) return *fault;
        if (is_blank(c)) {
            blank = !result.empty();
        } else if (is_ignorable(c)) {
            const bool between = !result.empty() && !blank && i + 1 < text.size();
            if ((c == kJoiner || c == kNonJoiner) && between &&
                shapes(c, result.back(), text[i + 1]))
                result.push_back(c);
        } else if (is_mark(c) && (result.empty() || blank)) {
            return NameFault{"must not have a combining mark without a character before it"};
        } else {
            if (blank) result.push_back(' ');
            blank = false;
            result.push_back(c);
        }
    }
    return result;
}

struct Free {
    void operator()(utf8proc_uint8_t* memory) const { std::free(memory); }
};

std::string encoded(const std::vector<CodePoint>& text) {
    std::string bytes;
    for (const CodePoint c : text) {
        std::array<utf8proc_uint8_t, 4> buffer{};
        const auto size = utf8proc_encode_char(c, buffer.data());
        bytes.append(buffer.begin(), buffer.begin() + size);
    }
    return bytes;
}

std::string composed(const std::string& text) {
    const std::unique_ptr<utf8proc_uint8_t, Free> result(
        utf8proc_NFC(reinterpret_cast<const utf8proc_uint8_t*>(text.c_str())));
    if (!result) throw std::bad_alloc();
    return reinterpret_cast<const char*>(result.get());
}

/// One pass: cleaned, then composed.
Result<std::string, NameFault> cleaned(std::string_view name) {
    auto text = decode(name);
    if (!text) return NameFault{"must be UTF-8"};
    trim(*text);
    const auto visible = visible_part(*text);
    if (!visible) return visible.error();
    if (visible->empty()) return NameFault{"must not be empty"};
    return composed(encoded(*visible));
}

}  // namespace

Result<std::string, NameFault> person_name(std::string_view entered) {
    constexpr NameFault kTooLong{"must be at most 32 bytes of UTF-8"};
    if (entered.size() > kMaxNameBytes) return kTooLong;
    std::string name(entered);
    for (;;) {
        auto next = cleaned(name);
        if (!next) return next.error();
        if (*next == name) break;
        // Composing moves marks, by which a joiner may come to stand where it shapes nothing.
        name = *std::move(next);
    }
    if (name.size() > kMaxNameBytes) return kTooLong;
    return name;
}

}  // namespace poolhall::protocol
