#include "server/store/store_database.hpp"

#include "protocol/archive/database.hpp"
#include "server/store/job_statements.hpp"
#include "server/store/migration.hpp"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Transaction.h>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace poolhall::server {

namespace {

using protocol::DatabaseState;
using protocol::describe;

void check_for_damage(SQLite::Database& database, const std::filesystem::path& path) {
    const std::string found = database.execAndGet("PRAGMA quick_check(1)").getString();
    if (found != "ok") throw std::runtime_error(path.string() + " is damaged: " + found);
}

/// A write-ahead log, so that readers never wait for the writer; FULL, so that a commit is on the
/// disk when it returns, even if the machine then loses power.
void set_durability(SQLite::Database& database, const std::filesystem::path& path) {
    const std::string mode = database.execAndGet("PRAGMA journal_mode = WAL").getString();
    if (mode != "wal")
        throw std::runtime_error(path.string() + ": the file system allows no write-ahead log");
    database.exec("PRAGMA synchronous = FULL");
    database.exec("PRAGMA foreign_keys = ON");
}

/// Changes nothing, but has to reach the disk: a full or read-only folder is found at the start,
/// not at the first shot.
void prove_writable(SQLite::Database& database) {
    SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
    database.exec("PRAGMA user_version = " + std::to_string(protocol::kDatabaseVersion));
    transaction.commit();
}

}  // namespace

Result<std::unique_ptr<StoreDatabase>, StoreDatabase::Error> StoreDatabase::open(
    const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) return Error{"cannot create the folder " + folder.string() + ": " + error.message()};
    auto lock = FolderLock::take(folder);
    if (!lock) return Error{lock.error().reason};
    const std::filesystem::path path = folder / protocol::kDatabaseFile;
    try {
        std::unique_ptr<StoreDatabase> store(new StoreDatabase(path, std::move(*lock)));
        store->prepare();
        return store;
    } catch (const SQLite::Exception& failure) {
        return Error{describe(path, failure, protocol::Access::kWrite)};
    } catch (const std::exception& failure) {
        return Error{failure.what()};
    }
}

StoreDatabase::StoreDatabase(std::filesystem::path path, FolderLock lock)
    : path_(std::move(path)),
      lock_(std::move(lock)),
      database_(path_.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE) {}

/// Throws what is wrong with the database, before anything of it has been changed; brings one of an
/// earlier version up to this one's.
void StoreDatabase::prepare() {
    const DatabaseState state = protocol::state_of(database_);
    if (state == DatabaseState::kForeign || state == DatabaseState::kNewer)
        throw std::runtime_error(describe(path_, state));
    check_for_damage(database_, path_);
    set_durability(database_, path_);
    if (state == DatabaseState::kEmpty) protocol::create_tables(database_);
    if (state == DatabaseState::kOlder) migrate(database_, path_);
    prove_writable(database_);
}

StoreDatabase::~StoreDatabase() {
    // Where a reader holds it up, the log stays and the next start takes it in.
    database_.tryExec("PRAGMA wal_checkpoint(TRUNCATE)");
}

std::vector<JobFailure> StoreDatabase::apply(std::span<const StoreJob* const> jobs) {
    std::vector<JobFailure> failures;
    try {
        SQLite::Transaction transaction(database_, SQLite::TransactionBehavior::IMMEDIATE);
        JobStatements statements(database_);
        for (const StoreJob* job : jobs)
            failures.push_back(statements.apply(*job));
        transaction.commit();
    } catch (const SQLite::Exception& failure) {
        failures.assign(jobs.size(), describe(path_, failure, protocol::Access::kWrite));
    } catch (const std::exception& failure) {
        failures.assign(jobs.size(), path_.string() + ": " + failure.what());
    }
    return failures;
}

}  // namespace poolhall::server
