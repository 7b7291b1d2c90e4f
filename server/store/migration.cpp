#include "server/store/migration.hpp"

#include "protocol/archive/database.hpp"

#include <SQLiteCpp/Backup.h>
#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Exception.h>
#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <sqlite3.h>
#include <stdexcept>
#include <string>
#include <system_error>
#include <unistd.h>

namespace poolhall::server {

namespace {

using std::filesystem::path;

[[noreturn]] void fail(const path& file, const std::string& reason) {
    throw std::runtime_error("the copy " + file.string() + " cannot be written: " + reason);
}

/// Waits until the file, or the names in a folder, are on the disk.
void make_durable(const path& file) {
    const int opened = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    const bool good = opened >= 0 && ::fsync(opened) == 0;
    const int error = errno;
    if (opened >= 0) ::close(opened);
    if (!good) fail(file, std::generic_category().message(error));
}

bool have_same_bytes(const path& a, const path& b) {
    std::ifstream first(a, std::ios::binary);
    std::ifstream second(b, std::ios::binary);
    using Bytes = std::istreambuf_iterator<char>;
    return first && second && std::equal(Bytes(first), Bytes(), Bytes(second), Bytes());
}

/// A file that is gone again unless it is kept.
class PartFile {
  public:
    explicit PartFile(path name) : name_(std::move(name)) { remove(); }

    ~PartFile() { remove(); }

    PartFile(const PartFile&) = delete;
    PartFile& operator=(const PartFile&) = delete;
    PartFile(PartFile&&) = delete;
    PartFile& operator=(PartFile&&) = delete;

    [[nodiscard]] const path& name() const { return name_; }

  private:
    void remove() const {
        std::error_code ignored;
        for (const char* suffix : {"", "-journal"})
            std::filesystem::remove(name_.string() + suffix, ignored);
    }

    path name_;
};

/// Copies by SQLite's backup: what still stands in the write-ahead log is in it, too.
void copy_to(SQLite::Database& database, const path& file) {
    try {
        SQLite::Database copy(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
        if (SQLite::Backup(copy, database).executeStep() != SQLITE_DONE)
            fail(file, "the database is in use");
    } catch (const SQLite::Exception& error) {
        fail(file, error.getErrorStr());
    }
}

/// Where a copy may stand: the first free name, or that of a copy that is the same.
path copy_name(const path& database, int version, const path& part) {
    const std::string first = database.string() + ".v" + std::to_string(version);
    path name = first;
    for (int next = 2;
         std::filesystem::symlink_status(name).type() != std::filesystem::file_type::not_found;
         ++next) {
        if (have_same_bytes(name, part)) break;
        name = first + "." + std::to_string(next);
    }
    return name;
}

void keep_copy(SQLite::Database& database, const path& file) {
    const int version = database.execAndGet("PRAGMA user_version").getInt();
    const PartFile part(file.string() + ".part");
    copy_to(database, part.name());
    std::error_code error;
    // It holds the hashes of players' tokens, so nobody else may read it who could not before.
    std::filesystem::permissions(part.name(), std::filesystem::status(file).permissions(), error);
    if (error) fail(part.name(), error.message());
    make_durable(part.name());
    const path name = copy_name(file, version, part.name());
    std::filesystem::rename(part.name(), name, error);
    if (error) fail(name, error.message());
    make_durable(file.parent_path() / ".");
}

}  // namespace

void migrate(SQLite::Database& database, const path& file) {
    keep_copy(database, file);
    protocol::migrate_tables(database);
}

}  // namespace poolhall::server
