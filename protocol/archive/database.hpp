#pragma once

#include "shared/game/seat.hpp"

#include <filesystem>
#include <string>
#include <string_view>

// The tables of a replay store; REPLAY_FORMAT.md describes them. Only server/store writes them.
namespace SQLite {
class Database;
class Exception;
}  // namespace SQLite

namespace poolhall::protocol {

inline constexpr std::string_view kDatabaseFile = "poolhall.sqlite";  ///< in the data folder
inline constexpr int kApplicationId = 0x504F4F4C;  ///< "POOL"; PRAGMA application_id
inline constexpr int kDatabaseVersion = 2;         ///< PRAGMA user_version

/// Whose tables a database holds.
enum class DatabaseState {
    kEmpty,    ///< nobody's yet
    kOlder,    ///< ours, of an earlier version: it can be read, and migrated
    kCurrent,  ///< ours, of kDatabaseVersion
    kNewer,    ///< ours, of a later version
    kForeign,  ///< not ours
};

/// Throws SQLite::Exception if the file cannot be read.
[[nodiscard]] DatabaseState state_of(SQLite::Database& database);

/// Creates the tables in an empty database, in one transaction. Throws SQLite::Exception.
void create_tables(SQLite::Database& database);

/// Brings an older database to kDatabaseVersion, in one transaction; its records stay as they are.
/// Throws SQLite::Exception; nothing has been changed then.
void migrate_tables(SQLite::Database& database);

/// SQL of what version 1 did not count, for a row of matches: its games that are finished, and
/// those won by whoever sat last on a seat, since they sat down.
[[nodiscard]] std::string games_from_records();
[[nodiscard]] std::string wins_from_records(Seat seat);

enum class Access { kRead, kWrite };

/// One sentence with the path: what SQLite met. Where a file is in the way that this process may
/// not read, or write if it wants to, be it the database or one that SQLite keeps beside it, that
/// file is named with its owner.
[[nodiscard]] std::string describe(const std::filesystem::path& path,
                                   const SQLite::Exception& error, Access access);
/// One sentence with the path: why a database in this state (not kOlder or kCurrent) cannot be
/// used.
[[nodiscard]] std::string describe(const std::filesystem::path& path, DatabaseState state);

}  // namespace poolhall::protocol
