#pragma once

#include <optional>
#include <string>
#include <string_view>

// Text that comes from outside.
namespace poolhall::protocol {

/// Well-formed UTF-8: no overlong forms, surrogates or code points beyond U+10FFFF.
[[nodiscard]] bool is_utf8(std::string_view text);

/// Why a player's name cannot be shown: empty, too long, blank, or with characters that control a
/// terminal or turn the direction of the text around it. Nothing if it can. `name` must be UTF-8.
[[nodiscard]] std::optional<std::string_view> find_name_fault(std::string_view name);

/// A join code as people type it ("bcd-fgh", "BCD FGH") in the form that is kept ("BCDFGH");
/// nothing if it is none.
[[nodiscard]] std::optional<std::string> normalize_code(std::string_view typed);

/// A join code in two groups, as people read it: "BCD-FGH"; what is none as it is.
[[nodiscard]] std::string spoken_code(std::string_view code);

/// 32 lower-case hex digits.
[[nodiscard]] bool is_token(std::string_view text);

/// A C hex-float ("0x1.8p-1", "-0X1P3"), exactly; nothing if the text is none, or a number that no
/// double is. Independent of the locale.
[[nodiscard]] std::optional<double> parse_hex_float(std::string_view text);

/// The same the other way, "0x1.8p-1": short, and exact. Requires a finite number.
[[nodiscard]] std::string to_hex_float(double number);

/// A key as it may stand in an error: cut to a readable length, without control characters.
[[nodiscard]] std::string shown(std::string_view key);

}  // namespace poolhall::protocol
