#pragma once

#include "protocol/replay/record.hpp"

#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <string_view>

namespace poolhall::protocol {

/// What can be wrong with a replay.
enum class DamageKind : std::uint8_t {
    kTornLine,     ///< the last line has no line end: the file was cut
    kLineTooLong,  ///< longer than kMaxReplayLineBytes
    kNotARecord,   ///< not {"sum":"...","record":...}
    kChecksum,
    kBadJson,
    kBadField,
    kUnknownVersion,  ///< no damage: a later version of the program wrote it
    kMissingRecord,   ///< the numbers have a gap, or there is no first record
    kOutOfPlace,      ///< a match record that is not the first, or a record after the end
    kUnreadable,      ///< the stream failed
};

/// Where reading stopped, and why. What stands before it is good.
struct Damage {
    DamageKind kind = DamageKind::kTornLine;
    std::uint64_t line = 0;    ///< from 1; equal to the record's number in an undamaged file
    std::uint64_t offset = 0;  ///< of the line's first byte
    std::string reason;        ///< one sentence without a full stop

    /// "line 3, byte 512: the checksum does not match".
    [[nodiscard]] std::string text() const;
};

/// Reads a replay file record by record. It reads up to the first damage and not beyond: what
/// follows a damaged line cannot be trusted to follow what stood before it. Never throws.
class ReplayReader {
  public:
    /// The stream must live as long as the reader.
    explicit ReplayReader(std::istream& input) : input_(input) {}

    /// The next record; nothing at the end or at damage.
    [[nodiscard]] std::optional<NumberedRecord> next();

    /// What stopped the reading; nothing at a good end.
    [[nodiscard]] const std::optional<Damage>& damage() const { return damage_; }

    /// JSON of the record that next() gave, as it stands in the file; valid until next() is called
    /// again.
    [[nodiscard]] std::string_view text() const { return text_; }

    /// True once the match's EndRecord has been read. Without it the match was still open when the
    /// file was written, or whole lines are missing at its end: the two cannot be told apart.
    [[nodiscard]] bool ended() const { return ended_; }

  private:
    bool read_line();
    std::optional<NumberedRecord> parse_line();
    bool in_place(const NumberedRecord& record);
    void stop(DamageKind kind, std::string reason);

    std::istream& input_;
    std::string line_;
    std::string_view text_;
    std::uint64_t lines_ = 0;    ///< begun so far
    std::uint64_t line_at_ = 0;  ///< offset of line_
    std::uint64_t next_at_ = 0;  ///< offset of what follows line_
    bool ended_ = false;
    std::optional<Damage> damage_;
};

}  // namespace poolhall::protocol
