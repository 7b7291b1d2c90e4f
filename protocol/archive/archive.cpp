#include "protocol/archive/archive.hpp"

#include "protocol/archive/read_connection.hpp"
#include "protocol/replay/line.hpp"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Statement.h>
#include <algorithm>
#include <limits>
#include <system_error>
#include <utility>

namespace poolhall::protocol {

namespace {

/// A server is seldom started and stopped; more often within one reading would be a strange one.
constexpr int kTries = 5;

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
        auto connection = std::make_unique<ReadConnection>(path);
        const DatabaseState state = state_of(connection->database());
        if (state != DatabaseState::kCurrent && state != DatabaseState::kOlder)
            return ArchiveError{describe(path, state)};
        return ReplayArchive(std::move(path), std::move(connection));
    } catch (const SQLite::Exception& failure) {
        return ArchiveError{describe(path, failure, Access::kRead)};
    }
}

/// What the query finds. It is asked again where a server began, ended or was killed under it.
template <class Query>
auto ReplayArchive::read(Query query) const
    -> Result<decltype(query(std::declval<SQLite::Database&>())), ArchiveError> {
    for (int tries = 1; tries <= kTries; ++tries) {
        try {
            if (tries > 1) *connection_ = ReadConnection(path_);
            auto found = query(connection_->database());
            if (connection_->is_current()) return found;
        } catch (const SQLite::Exception& failure) {
            if (tries == kTries || (tries > 1 && connection_->is_current()))
                return ArchiveError{describe(path_, failure, Access::kRead)};
        }
    }
    return ArchiveError{path_.string() + " is in use by another program"};
}

Result<std::vector<ReplaySummary>, ArchiveError> ReplayArchive::list(
    std::size_t limit, std::optional<std::uint64_t> before) const {
    constexpr std::uint64_t kLast = std::numeric_limits<std::int64_t>::max();
    return read([&](SQLite::Database& database) {
        SQLite::Statement query(database, list_query(database));
        query.bind(1, static_cast<std::int64_t>(std::min(before.value_or(kLast), kLast)));
        query.bind(2, static_cast<std::int64_t>(std::min<std::uint64_t>(limit, kLast)));
        std::vector<ReplaySummary> summaries;
        while (query.executeStep())
            summaries.push_back(read_summary(query));
        return summaries;
    });
}

Result<std::optional<std::string>, ArchiveError> ReplayArchive::export_match(
    std::string_view id) const {
    return read([&](SQLite::Database& database) {
        SQLite::Statement query(database, kExportQuery);
        query.bind(1, std::string(id));
        std::optional<std::string> text;
        while (query.executeStep()) {
            const std::string sum = query.getColumn(0).getString();
            const std::string body = query.getColumn(1).getString();
            if (!text) text.emplace();
            *text += to_line({sum, body});
        }
        return text;
    });
}

ReplayArchive::ReplayArchive(std::filesystem::path path, std::unique_ptr<ReadConnection> connection)
    : path_(std::move(path)), connection_(std::move(connection)) {}

ReplayArchive::ReplayArchive(ReplayArchive&& other) noexcept = default;
ReplayArchive& ReplayArchive::operator=(ReplayArchive&& other) noexcept = default;
ReplayArchive::~ReplayArchive() = default;

}  // namespace poolhall::protocol
