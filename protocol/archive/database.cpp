#include "protocol/archive/database.hpp"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Transaction.h>
#include <cerrno>
#include <fcntl.h>
#include <optional>
#include <sqlite3.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace poolhall::protocol {

namespace {

/// Shot records are larger than what fits well into a WITHOUT ROWID table; with a rowid they are
/// appended at the end.
constexpr const char* kTables = R"(
CREATE TABLE matches (
    num        INTEGER PRIMARY KEY,
    id         TEXT    NOT NULL UNIQUE,
    code       TEXT    NOT NULL,
    game       TEXT    NOT NULL,
    shots      INTEGER NOT NULL DEFAULT 0,
    created_ms INTEGER NOT NULL,
    closed_ms  INTEGER,
    games      INTEGER NOT NULL DEFAULT 0
) STRICT;
CREATE UNIQUE INDEX open_codes ON matches (code) WHERE closed_ms IS NULL;
CREATE TABLE seats (
    match      INTEGER NOT NULL REFERENCES matches (num),
    seat       INTEGER NOT NULL CHECK (seat IN (0, 1)),
    name       TEXT    NOT NULL,
    last_name  TEXT    NOT NULL,
    token_hash TEXT    NOT NULL,
    wins       INTEGER NOT NULL DEFAULT 0,
    PRIMARY KEY (match, seat)
) WITHOUT ROWID, STRICT;
CREATE TABLE records (
    num   INTEGER PRIMARY KEY,
    match INTEGER NOT NULL REFERENCES matches (num),
    n     INTEGER NOT NULL,
    kind  TEXT    NOT NULL,
    body  TEXT    NOT NULL,
    sum   TEXT    NOT NULL,
    UNIQUE (match, n)
) STRICT;
)";

constexpr int kFirstDatabaseVersion = 1;

/// The seat that a record of a won game names; NULL of any other, and of one that is damaged.
constexpr const char* kWinner =
    "CASE WHEN json_valid(body) THEN json_extract(body, '$.ruling.winner') END";

int pragma(SQLite::Database& database, const char* query) {
    return database.execAndGet(query).getInt();
}

/// Why this process may not use the file or folder; nothing if it may, or there is none.
std::optional<std::string> barrier_at(const std::string& file, Access access) {
    struct stat found {};

    const bool writes = access == Access::kWrite;
    if (::stat(file.c_str(), &found) != 0) return std::nullopt;
    if (::faccessat(AT_FDCWD, file.c_str(), writes ? R_OK | W_OK : R_OK, AT_EACCESS) == 0)
        return std::nullopt;
    return file + (writes ? " cannot be written: " : " cannot be read: ") +
           std::generic_category().message(errno) + "; it belongs to user " +
           std::to_string(found.st_uid);
}

/// What keeps this process from the database, the files beside it or their folder.
std::optional<std::string> find_barrier(const std::filesystem::path& path, Access access) {
    for (const char* suffix : {"", "-wal", "-shm"})
        if (auto barrier = barrier_at(path.string() + suffix, access)) return barrier;
    return barrier_at(path.parent_path().string(), access);
}

}  // namespace

DatabaseState state_of(SQLite::Database& database) {
    const int application = pragma(database, "PRAGMA application_id");
    const int version = pragma(database, "PRAGMA user_version");
    const int tables = pragma(database, "SELECT count(*) FROM sqlite_schema");
    if (application == 0 && version == 0 && tables == 0) return DatabaseState::kEmpty;
    if (application != kApplicationId) return DatabaseState::kForeign;
    if (version > kDatabaseVersion) return DatabaseState::kNewer;
    if (version == kDatabaseVersion) return DatabaseState::kCurrent;
    return version >= kFirstDatabaseVersion ? DatabaseState::kOlder : DatabaseState::kForeign;
}

void create_tables(SQLite::Database& database) {
    SQLite::Transaction transaction(database);
    database.exec(kTables);
    database.exec("PRAGMA application_id = " + std::to_string(kApplicationId));
    database.exec("PRAGMA user_version = " + std::to_string(kDatabaseVersion));
    transaction.commit();
}

std::string games_from_records() {
    return std::string("(SELECT count(*) FROM records WHERE match = matches.num AND ") + kWinner +
           " IS NOT NULL)";
}

std::string wins_from_records(Seat seat) {
    const std::string number = std::to_string(seat.value);
    return std::string("(SELECT count(*) FROM records WHERE match = matches.num AND ") + kWinner +
           " = " + number +
           " AND n > (SELECT coalesce(max(n), 0) FROM records WHERE match = matches.num AND "
           "kind = 'seat' AND CASE WHEN json_valid(body) THEN json_extract(body, '$.seat') = " +
           number + " AND json_extract(body, '$.name') <> '' END))";
}

void migrate_tables(SQLite::Database& database) {
    SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
    database.exec("ALTER TABLE matches ADD COLUMN games INTEGER NOT NULL DEFAULT 0");
    database.exec("ALTER TABLE seats ADD COLUMN wins INTEGER NOT NULL DEFAULT 0");
    database.exec("UPDATE matches SET games = " + games_from_records());
    for (const Seat seat : kSeats)
        database.exec(
            "UPDATE seats SET wins = (SELECT " + wins_from_records(seat) +
            " FROM matches WHERE num = seats.match) WHERE seat = " + std::to_string(seat.value));
    database.exec("PRAGMA user_version = " + std::to_string(kDatabaseVersion));
    transaction.commit();
}

std::string describe(const std::filesystem::path& path, const SQLite::Exception& error,
                     Access access) {
    const std::string file = path.string();
    const int code = error.getErrorCode();
    if (code == SQLITE_CANTOPEN || code == SQLITE_PERM || code == SQLITE_READONLY)
        if (auto barrier = find_barrier(path, access)) return *barrier;
    switch (code) {
        case SQLITE_NOTADB:
            return file + " is not a database";
        case SQLITE_CORRUPT:
            return file + " is damaged: " + error.getErrorStr();
        case SQLITE_CANTOPEN:
            return file + " cannot be opened";
        case SQLITE_PERM:
        case SQLITE_READONLY:
            return file + " cannot be written";
        case SQLITE_FULL:
            return "no space is left for " + file;
        case SQLITE_IOERR:
            return file + " cannot be read or written: " + error.what();
        case SQLITE_BUSY:
            return file + " is in use by another program";
        default:
            return file + ": " + error.what();
    }
}

std::string describe(const std::filesystem::path& path, DatabaseState state) {
    const std::string file = path.string();
    switch (state) {
        case DatabaseState::kEmpty:
            return file + " is empty";
        case DatabaseState::kNewer:
            return file + " was written by a newer version of Poolhall";
        case DatabaseState::kForeign:
            return file + " is not a Poolhall replay store";
        case DatabaseState::kOlder:
        case DatabaseState::kCurrent:
            break;
    }
    return file + " is in order";
}

}  // namespace poolhall::protocol
