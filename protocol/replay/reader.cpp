#include "protocol/replay/reader.hpp"

#include "protocol/replay/line.hpp"
#include "protocol/replay/record_text.hpp"

#include <utility>

namespace poolhall::protocol {

namespace {

constexpr auto kEnd = std::istream::traits_type::eof();

DamageKind kind_of(RecordFault fault) {
    switch (fault) {
        case RecordFault::kNotJson:
            return DamageKind::kBadJson;
        case RecordFault::kUnknownVersion:
            return DamageKind::kUnknownVersion;
        case RecordFault::kBadField:
            break;
    }
    return DamageKind::kBadField;
}

}  // namespace

std::string Damage::text() const {
    return "line " + std::to_string(line) + ", byte " + std::to_string(offset) + ": " + reason;
}

std::optional<NumberedRecord> ReplayReader::next() {
    text_ = {};
    if (damage_ || !read_line()) return std::nullopt;
    auto record = parse_line();
    if (!record || !in_place(*record)) return std::nullopt;
    ended_ = std::holds_alternative<EndRecord>(record->record);
    return record;
}

/// Fills line_ without its line end, LF or CRLF. std::getline would not bound the length.
bool ReplayReader::read_line() {
    line_.clear();
    line_at_ = next_at_;
    ++lines_;
    try {
        std::streambuf& bytes = *input_.rdbuf();
        for (auto byte = bytes.sbumpc(); byte != kEnd; byte = bytes.sbumpc()) {
            ++next_at_;
            if (byte == '\n') {
                // A record's line ends with "}": a CR at its end is what some program added.
                if (line_.ends_with('\r')) line_.pop_back();
                return true;
            }
            const bool may_end = byte == '\r' && line_.size() == kMaxReplayLineBytes;
            if (line_.size() >= kMaxReplayLineBytes && !may_end) {
                stop(DamageKind::kLineTooLong, "the line is longer than 1 MiB");
                return false;
            }
            line_.push_back(std::istream::traits_type::to_char_type(byte));
        }
    } catch (const std::exception&) {
        // A file buffer reports a failed read, of a folder for instance, by throwing.
        stop(DamageKind::kUnreadable, "the file cannot be read");
        return false;
    }
    if (!line_.empty()) {
        stop(DamageKind::kTornLine, "the last line is cut short");
    } else if (lines_ == 1) {
        stop(DamageKind::kMissingRecord, "there is no record");
    }
    return false;
}

std::optional<NumberedRecord> ReplayReader::parse_line() {
    const auto parts = split_line(line_);
    if (!parts) {
        stop(DamageKind::kNotARecord, R"(the line is not {"sum":"<16 hex digits>","record":...})");
        return std::nullopt;
    }
    if (checksum_text(parts->record) != parts->sum) {
        stop(DamageKind::kChecksum, "the checksum does not match");
        return std::nullopt;
    }
    auto record = record_from_text(parts->record);
    if (!record) {
        const RecordError& error = record.error();
        stop(kind_of(error.fault),
             error.pointer.empty() ? error.reason : error.pointer + ": " + error.reason);
        return std::nullopt;
    }
    text_ = parts->record;
    return std::move(*record);
}

bool ReplayReader::in_place(const NumberedRecord& record) {
    const bool is_first = std::holds_alternative<MatchRecord>(record.record);
    if (record.n != lines_) {
        stop(DamageKind::kMissingRecord, "record " + std::to_string(record.n) +
                                             " stands where record " + std::to_string(lines_) +
                                             " must be");
    } else if (is_first != (lines_ == 1)) {
        stop(DamageKind::kOutOfPlace, is_first ? "a match record that is not the first"
                                               : "the first record is not a match record");
    } else if (ended_) {
        stop(DamageKind::kOutOfPlace, "a record after the end of the match");
    }
    return !damage_;
}

void ReplayReader::stop(DamageKind kind, std::string reason) {
    text_ = {};
    damage_ = Damage{kind, lines_, line_at_, std::move(reason)};
}

}  // namespace poolhall::protocol
