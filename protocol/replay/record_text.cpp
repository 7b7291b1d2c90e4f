#include "protocol/replay/record_text.hpp"

#include "protocol/replay/record_fields.hpp"
#include "protocol/text.hpp"
#include "protocol/tree.hpp"

#include <nlohmann/json.hpp>
#include <utility>

namespace poolhall::protocol {

namespace {

using wire::Cursor;
using wire::Json;

constexpr std::size_t kMaxMatchIdBytes = 64;

constexpr std::string_view kFormatPrefix = "poolhall.replay/";

std::string format_of(int version) {
    return std::string(kFormatPrefix) + std::to_string(version);
}

/// Only the first record of a match names the format.
bool read_format(const Json& format, int& version) {
    for (version = kFirstReplayVersion; version <= kReplayVersion; ++version) {
        if (format == format_of(version)) return true;
    }
    return false;
}

RecordError unknown_version(const Json& format) {
    const std::string named = format.is_string() ? format.get<std::string>() : format.dump();
    return {"/format",
            "the version \"" + shown(named) + "\" is none that this program knows: it reads \"" +
                format_of(kFirstReplayVersion) + "\" and \"" + format_of(kReplayVersion) + "\"",
            RecordFault::kUnknownVersion};
}

/// What the fields alone do not say.
bool check_times(const Cursor& cursor, const std::vector<double>& times, std::uint32_t events,
                 std::string_view pointer) {
    if (times.empty() || times.size() == events) return true;
    return cursor.refuse_at(pointer, "must have one time for each event, or none");
}

bool check_whole(const Cursor& cursor, const ShotRecord& record) {
    return check_times(cursor, record.event_times, record.event_count, "/event_times");
}

bool check_whole(const Cursor& cursor, const MoveRecord& record) {
    if (record.shot.has_value() != std::holds_alternative<Shoot>(record.move))
        return cursor.refuse_at("/shot", "must be there for a shot and for no other move");
    return !record.shot || check_times(cursor, record.shot->event_times, record.shot->event_count,
                                       "/shot/event_times");
}

bool check_whole(const Cursor& cursor, MatchRecord& record) {
    const Json* format = cursor.find("format");
    if (format == nullptr) return cursor.refuse_missing("format");
    static_cast<void>(read_format(*format, record.version));
    if (record.first.has_value() == (record.version >= 2)) return true;
    return cursor.refuse_at("/first", "must be there from version 2 on, and not before");
}

template <class Record>
bool check_whole(const Cursor& /*cursor*/, const Record& /*record*/) {
    return true;
}

template <class Record>
bool read_as(const Cursor& cursor, ReplayRecord& record) {
    constexpr bool kHasFormat = std::is_same_v<Record, MatchRecord>;
    auto& fields = record.emplace<Record>();
    const char* format = kHasFormat ? "format" : "kind";
    return wire::read_fields(cursor, fields, {"n", "kind", format}) && check_whole(cursor, fields);
}

template <class... Records>
bool read_kind(const Cursor& cursor, std::string_view kind, std::variant<Records...>& record) {
    bool good = false;
    const bool known =
        ((kind == Records::kKind && (good = read_as<Records>(cursor, record), true)) || ...);
    return known ? good
                 : cursor.refuse_at("/kind", "is not a kind of record that this version knows");
}

bool read_record(const Cursor& cursor, NumberedRecord& numbered) {
    if (!cursor.json().is_object()) return cursor.refuse("must be an object");
    const Json* n = cursor.find("n");
    if (n == nullptr) return cursor.refuse_missing("n");
    if (!wire::Count{1}.read(cursor.field("n", *n), numbered.n)) return false;
    const Json* kind = cursor.find("kind");
    if (kind == nullptr) return cursor.refuse_missing("kind");
    if (!wire::expect_text(cursor.field("kind", *kind))) return false;
    return read_kind(cursor, kind->get_ref<const std::string&>(), numbered.record);
}

}  // namespace

bool wire::MatchId::read(const Cursor& cursor, std::string& value) const {
    if (!expect_text(cursor)) return false;
    value = cursor.json().get<std::string>();
    return is_match_id(value) || cursor.refuse("must be 1 to 64 of A-Z a-z 0-9 _ -");
}

std::string to_text(std::uint64_t n, const ReplayRecord& record) {
    Json object{{"n", n}, {"kind", kind_of(record)}};
    if (const auto* match = std::get_if<MatchRecord>(&record))
        object["format"] = format_of(match->version);
    std::visit([&](const auto& fields) { wire::write_fields(object, fields, Encoding::kJson); },
               record);
    return write_tree(object, Encoding::kJson);
}

Result<NumberedRecord, RecordError> record_from_text(std::string_view text) {
    const auto tree = parse_tree(text, Encoding::kJson);
    if (!tree) return RecordError{"", tree.error().reason, RecordFault::kNotJson};
    if (tree->is_object() && tree->contains("format")) {
        int version = 0;
        const Json& format = tree->at("format");
        if (!read_format(format, version)) return unknown_version(format);
    }
    wire::Reading reading;
    NumberedRecord record;
    if (read_record(Cursor(*tree, reading), record)) return record;
    return RecordError{reading.error->pointer, reading.error->reason, RecordFault::kBadField};
}

bool is_match_id(std::string_view id) {
    constexpr std::string_view kAllowed =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-";
    return !id.empty() && id.size() <= kMaxMatchIdBytes &&
           id.find_first_not_of(kAllowed) == std::string_view::npos;
}

}  // namespace poolhall::protocol
