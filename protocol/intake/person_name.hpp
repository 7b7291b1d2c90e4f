#pragma once

#include "shared/result.hpp"

#include <string>
#include <string_view>

// What people are called, as they enter it. Needs Unicode's tables (utf8proc), which whoever only
// reads what a server sends does without: find_name_fault is for those.
namespace poolhall::protocol {

struct NameFault {
    std::string_view reason;  ///< completes "the name ...": "must not be empty"
};

/// The name in the one form that is kept, so that names that look alike are alike: NFC, without
/// blanks at its ends, with one space for each run of blanks within, without characters that
/// Unicode lets a display ignore (joiners stay where they shape the letters beside them). A name is
/// refused that is longer than kMaxNameBytes before or after that, is not UTF-8, has nothing
/// visible, a combining mark with nothing to combine with, a control character, an override of the
/// direction of text, or a code point that is unassigned or for private use. PROTOCOL.md has this
/// for people to read. Throws std::bad_alloc only.
[[nodiscard]] Result<std::string, NameFault> person_name(std::string_view entered);

}  // namespace poolhall::protocol
