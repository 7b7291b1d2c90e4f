#include "protocol/archive/database.hpp"
#include "protocol/replay/reader.hpp"
#include "server/store/replay_store.hpp"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Statement.h>
#include <sstream>
#include <utility>

namespace poolhall::server {

namespace {

std::vector<StoredMatch> read_matches(const SQLite::Database& database) {
    SQLite::Statement query(database,
                            "SELECT id, code FROM matches WHERE closed_ms IS NULL ORDER BY num");
    std::vector<StoredMatch> matches;
    while (query.executeStep()) {
        StoredMatch& match = matches.emplace_back();
        match.id = query.getColumn(0).getString();
        match.code = query.getColumn(1).getString();
    }
    return matches;
}

void read_seats(const SQLite::Database& database, StoredMatch& match) {
    SQLite::Statement query(database,
                            "SELECT seat, name, token_hash FROM seats "
                            "JOIN matches ON seats.match = matches.num WHERE id = ?");
    query.bind(1, match.id);
    while (query.executeStep()) {
        StoredMatch::StoredSeat& seat = match.seats.at(query.getColumn(0).getUInt());
        seat.name = query.getColumn(1).getString();
        seat.token_hash = query.getColumn(2).getString();
    }
}

/// Reads a match's log; what is wrong with it, or nothing.
std::optional<std::string> read_records(const protocol::ReplayArchive& archive,
                                        StoredMatch& match) {
    const auto text = archive.export_match(match.id);
    if (!text) return text.error().reason;
    std::istringstream input(text.value().value_or(""));
    protocol::ReplayReader reader(input);
    while (auto record = reader.next())
        match.records.push_back(std::move(record->record));
    if (reader.damage()) return reader.damage()->text();
    return std::nullopt;
}

}  // namespace

Result<OpenMatches, StoreError> ReplayStore::load_open_matches() const {
    const auto archive = open_archive();
    if (!archive) return StoreError{archive.error().reason};
    const std::filesystem::path path = data_ / protocol::kDatabaseFile;
    OpenMatches open;
    try {
        const SQLite::Database database(path.string(), SQLite::OPEN_READONLY);
        for (StoredMatch& match : read_matches(database)) {
            read_seats(database, match);
            if (auto damage = read_records(*archive, match)) {
                open.damaged.push_back("match " + match.id + " cannot be resumed: " + *damage);
            } else {
                open.matches.push_back(std::move(match));
            }
        }
    } catch (const SQLite::Exception& failure) {
        return StoreError{protocol::describe(path, failure, protocol::Access::kWrite)};
    }
    return open;
}

}  // namespace poolhall::server
