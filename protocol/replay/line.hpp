#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

// The envelope of a record in a replay file: {"sum":"<16 hex digits>","record":<JSON of the
// record>}
namespace poolhall::protocol {

/// A longer line is damage: nothing that reads replays need hold more in memory.
inline constexpr std::size_t kMaxReplayLineBytes = std::size_t{1} << 20U;

/// FNV-1a, 64 bits, of the bytes. Each step is a bijection, so a single wrong byte never goes
/// unnoticed. It finds damage; it is no defence against forgery.
[[nodiscard]] constexpr std::uint64_t checksum(std::string_view bytes) {
    std::uint64_t sum = 0xCBF29CE484222325ULL;
    for (const char byte : bytes)
        sum = (sum ^ static_cast<unsigned char>(byte)) * 0x100000001B3ULL;
    return sum;
}

/// checksum() as 16 lower-case hex digits.
[[nodiscard]] std::string checksum_text(std::string_view bytes);

/// A line taken apart; both are parts of the line.
struct LineParts {
    std::string_view sum;
    std::string_view record;
};

/// The line of a record's text, with its line end.
[[nodiscard]] std::string to_line(const LineParts& parts);

/// Takes a line (without its line end) apart; nothing if it does not have the form to the byte.
/// Checks no sum.
[[nodiscard]] std::optional<LineParts> split_line(std::string_view line);

}  // namespace poolhall::protocol
