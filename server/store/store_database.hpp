#pragma once

#include "server/store/folder_lock.hpp"
#include "server/store/job.hpp"
#include "shared/result.hpp"

#include <SQLiteCpp/Database.h>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace poolhall::server {

/// The writing connection to the tables of protocol/archive/database.hpp. For one thread at a time.
class StoreDatabase {
  public:
    struct Error {
        std::string reason;  ///< one sentence with the path
    };

    /// Opens or creates the database in the folder, locks the folder, looks for damage and proves
    /// that the folder can be written.
    [[nodiscard]] static Result<std::unique_ptr<StoreDatabase>, Error> open(
        const std::filesystem::path& folder);

    /// Moves what the write-ahead log holds into the database, as far as readers allow, and closes.
    ~StoreDatabase();
    StoreDatabase(const StoreDatabase&) = delete;
    StoreDatabase& operator=(const StoreDatabase&) = delete;
    StoreDatabase(StoreDatabase&&) = delete;
    StoreDatabase& operator=(StoreDatabase&&) = delete;

    /// Does all jobs in one durable transaction; gives an answer for each, in their order. A job
    /// that makes no sense is refused by itself; if the transaction fails, all of them fail. Never
    /// throws SQLite::Exception.
    [[nodiscard]] std::vector<JobFailure> apply(std::span<const StoreJob* const> jobs);

  private:
    StoreDatabase(std::filesystem::path path, FolderLock lock);
    void prepare();

    std::filesystem::path path_;
    FolderLock lock_;
    SQLite::Database database_;
};

}  // namespace poolhall::server
