#pragma once

#include <SQLiteCpp/Database.h>
#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>

namespace poolhall::protocol {

/// A connection that only reads a replay store and creates, changes and removes no file, whether a
/// server writes to the store meanwhile, has ended in order, was killed, or the files were copied
/// while one ran:
///
/// - Without a write-ahead log the database alone is complete, and is read as an immutable file.
/// - With a log whose index (-wal, -shm) a server keeps, both are used, the index read-only.
/// - With a log that no server keeps an index of, an index is made in memory. SQLite would do so by
///   itself where it may not write the one on the disk, but waits 10 s and gives up ("locking
///   protocol") if the log has a header only, as a server leaves it that is killed as it begins.
///
/// The first and the last need no lock and see no server that begins meanwhile: ask is_current().
class ReadConnection {
  public:
    /// Throws SQLite::Exception.
    explicit ReadConnection(std::filesystem::path path);

    [[nodiscard]] SQLite::Database& database() { return *database_; }

    /// False if a server may have written under a connection that does not see it: what was read is
    /// not to be trusted, and a new connection will see more.
    [[nodiscard]] bool is_current() const;

  private:
    /// What tells that somebody has written: inode, size, and time of change, ns, of the database
    /// and of its log; 0 for one that is not there.
    using Stamp = std::array<std::int64_t, 6>;

    void open_once();
    [[nodiscard]] bool open_with_index();  ///< whether a server keeps it, and it can be read
    void open_alone();
    void read_once();  ///< only a first read opens the log
    void connect(const char* vfs, const char* parameter);
    [[nodiscard]] Stamp stamp() const;

    std::filesystem::path path_;
    std::unique_ptr<SQLite::Database> database_;
    bool sees_writers_ = false;
    Stamp stamp_{};  ///< from before the database was opened
};

}  // namespace poolhall::protocol
