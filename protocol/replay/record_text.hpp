#pragma once

#include "protocol/replay/record.hpp"
#include "shared/result.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace poolhall::protocol {

enum class RecordFault : std::uint8_t {
    kNotJson,
    kUnknownVersion,  ///< whatever else is in it: a later version may have other fields
    kBadField,
};

/// What is wrong with the JSON of a record.
struct RecordError {
    std::string pointer;  ///< JSON pointer, "/scene/balls/0/r"; empty for the whole
    std::string reason;   ///< one sentence without a full stop
    RecordFault fault = RecordFault::kBadField;
};

/// The record as one line of JSON, without a line end: what a checksum covers and what is stored.
[[nodiscard]] std::string to_text(std::uint64_t n, const ReplayRecord& record);

/// Reads it back. Strict: every field of the format must be there, of its type and in range, and no
/// other: a reader that skipped what it does not know could simulate another shot than the one that
/// was played. Never throws.
[[nodiscard]] Result<NumberedRecord, RecordError> record_from_text(std::string_view text);

/// True for 1 to 64 of A-Z a-z 0-9 _ -.
[[nodiscard]] bool is_match_id(std::string_view id);

}  // namespace poolhall::protocol
