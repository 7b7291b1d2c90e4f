#include "protocol/archive/archive.hpp"

#include "protocol/replay/line.hpp"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Statement.h>
#include <algorithm>
#include <limits>
#include <sqlite3.h>
#include <system_error>
#include <utility>

namespace poolhall::protocol {

namespace {

constexpr int kBusyTimeoutMs = 2000;

/// A column of a seat of a row of matches; NULL if nobody ever sat there.
std::string seat_column(const std::string& column, Seat seat) {
    return "(SELECT " + column +
           " FROM seats WHERE match = matches.num AND seat = " + std::to_string(seat.value) + ")";
}

std::string list_query(SQLite::Database& database) {
    const bool counts = state_of(database) == DatabaseState::kCurrent;
    std::string query = "SELECT num, id, game, shots, created_ms, closed_ms, ";
    query += counts ? "games" : games_from_records();
    for (const Seat seat : kSeats) {
        query += ", " + seat_column("last_name", seat);
        query += ", " + (counts ? seat_column("wins", seat) : wins_from_records(seat));
    }
    return query + " FROM matches WHERE num < ? ORDER BY num DESC LIMIT ?";
}

constexpr const char* kExportQuery = R"(
SELECT records.sum, records.body FROM records JOIN matches ON records.match = matches.num
WHERE matches.id = ? ORDER BY records.n)";

/// The URI of a file on a medium that nobody can write: SQLite then needs neither locks nor a
/// shared-memory file.
std::string immutable_uri(const std::filesystem::path& path) {
    std::string uri = "file:";
    for (const char byte : path.string()) {
        if (byte == '%' || byte == '?' || byte == '#') {
            uri += byte == '%' ? "%25" : byte == '?' ? "%3f" : "%23";
        } else {
            uri += byte;
        }
    }
    return uri + "?immutable=1";
}

bool has_write_ahead_log(const std::filesystem::path& path) {
    std::error_code error;
    const auto size = std::filesystem::file_size(path.string() + "-wal", error);
    return !error && size > 0;
}

using OpenDatabase = std::pair<std::unique_ptr<SQLite::Database>, DatabaseState>;

OpenDatabase open_with(const std::string& name, int flags) {
    auto database = std::make_unique<SQLite::Database>(name, flags, kBusyTimeoutMs);
    const DatabaseState state = state_of(*database);
    return {std::move(database), state};
}

/// Reading a database in WAL mode wants a shared-memory file beside it, which a folder that cannot
/// be written does not allow. Without a log the file alone is complete.
OpenDatabase open_read_only(const std::filesystem::path& path) {
    try {
        return open_with(path.string(), SQLite::OPEN_READONLY);
    } catch (const SQLite::Exception& error) {
        const int code = error.getErrorCode();
        const bool no_companion_file = code == SQLITE_CANTOPEN || code == SQLITE_READONLY;
        if (!no_companion_file || has_write_ahead_log(path)) throw;
        return open_with(immutable_uri(path), SQLite::OPEN_READONLY | SQLite::OPEN_URI);
    }
}

ReplaySummary read_summary(SQLite::Statement& row) {
    ReplaySummary summary;
    summary.position = static_cast<std::uint64_t>(row.getColumn(0).getInt64());
    summary.id = row.getColumn(1).getString();
    summary.game = row.getColumn(2).getString();
    summary.shots = row.getColumn(3).getUInt();
    summary.created_ms = row.getColumn(4).getInt64();
    if (!row.isColumnNull(5)) summary.closed_ms = row.getColumn(5).getInt64();
    summary.games = row.getColumn(6).getUInt();
    for (const Seat seat : kSeats) {
        const int column = 7 + 2 * seat.value;
        summary.names[seat.value] = row.getColumn(column).getString();
        summary.wins[seat.value] = row.getColumn(column + 1).getUInt();
    }
    return summary;
}

}  // namespace

Result<ReplayArchive, ArchiveError> ReplayArchive::open(const std::filesystem::path& data) {
    std::filesystem::path path = data / kDatabaseFile;
    std::error_code error;
    if (!std::filesystem::exists(path, error)) {
        return ArchiveError{"there is no replay store at " + path.string()};
    }
    try {
        auto [database, state] = open_read_only(path);
        if (state != DatabaseState::kCurrent && state != DatabaseState::kOlder)
            return ArchiveError{describe(path, state)};
        return ReplayArchive(std::move(path), std::move(database));
    } catch (const SQLite::Exception& failure) {
        return ArchiveError{describe(path, failure)};
    }
}

Result<std::vector<ReplaySummary>, ArchiveError> ReplayArchive::list(
    std::size_t limit, std::optional<std::uint64_t> before) const {
    constexpr std::uint64_t kLast = std::numeric_limits<std::int64_t>::max();
    try {
        SQLite::Statement query(*database_, list_query(*database_));
        query.bind(1, static_cast<std::int64_t>(std::min(before.value_or(kLast), kLast)));
        query.bind(2, static_cast<std::int64_t>(std::min<std::uint64_t>(limit, kLast)));
        std::vector<ReplaySummary> summaries;
        while (query.executeStep())
            summaries.push_back(read_summary(query));
        return summaries;
    } catch (const SQLite::Exception& failure) {
        return ArchiveError{describe(path_, failure)};
    }
}

Result<std::optional<std::string>, ArchiveError> ReplayArchive::export_match(
    std::string_view id) const {
    try {
        SQLite::Statement query(*database_, kExportQuery);
        query.bind(1, std::string(id));
        std::optional<std::string> text;
        while (query.executeStep()) {
            const std::string sum = query.getColumn(0).getString();
            const std::string body = query.getColumn(1).getString();
            if (!text) text.emplace();
            *text += to_line({sum, body});
        }
        return text;
    } catch (const SQLite::Exception& failure) {
        return ArchiveError{describe(path_, failure)};
    }
}

ReplayArchive::ReplayArchive(std::filesystem::path path, std::unique_ptr<SQLite::Database> database)
    : path_(std::move(path)), database_(std::move(database)) {}

ReplayArchive::ReplayArchive(ReplayArchive&& other) noexcept = default;
ReplayArchive& ReplayArchive::operator=(ReplayArchive&& other) noexcept = default;
ReplayArchive::~ReplayArchive() = default;

}  // namespace poolhall::protocol
