#pragma once

#include <SQLiteCpp/Database.h>
#include <filesystem>

namespace poolhall::server {

/// Brings a database of an earlier version up to this one's, in one transaction, after a copy of it
/// was made durable beside it: PATH.v1 for version 1, or PATH.v1.2, PATH.v1.3, .. where another
/// copy stands already. Only one process may do that at a time. Throws SQLite::Exception, or
/// std::runtime_error with one sentence; the database is unchanged then.
void migrate(SQLite::Database& database, const std::filesystem::path& path);

}  // namespace poolhall::server
