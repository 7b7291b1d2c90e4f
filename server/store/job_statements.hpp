#pragma once

#include "server/store/job.hpp"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <cstdint>
#include <optional>
#include <string>

namespace poolhall::server {

/// The statements of one transaction. It keeps nothing in memory of what the tables hold, so that a
/// transaction that was rolled back leaves nothing to be undone here.
class JobStatements {
  public:
    explicit JobStatements(SQLite::Database& database);

    /// Does one job; refuses, having changed nothing, one that does not fit what is stored. Throws
    /// SQLite::Exception if the whole transaction cannot go on.
    [[nodiscard]] JobFailure apply(const StoreJob& job);

  private:
    struct OpenMatch {
        std::int64_t num = 0;      ///< matches.num
        std::uint64_t next_n = 0;  ///< of the match's next record
    };

    JobFailure apply_job(const CreateMatchJob& job);
    JobFailure apply_job(const SetSeatJob& job);
    JobFailure apply_job(const AppendMoveJob& job);
    JobFailure apply_job(const CloseMatchJob& job);

    std::optional<OpenMatch> find_open(const std::string& id);
    bool is_taken(const std::string& id, const std::string& code);
    void append(const OpenMatch& match, const protocol::ReplayRecord& record);

    SQLite::Database& database_;
    SQLite::Statement find_open_;
    SQLite::Statement is_taken_;
    SQLite::Statement create_;
    SQLite::Statement set_seat_;
    SQLite::Statement append_;
    SQLite::Statement count_shot_;
    SQLite::Statement count_game_;
    SQLite::Statement count_win_;
    SQLite::Statement close_;
};

}  // namespace poolhall::server
