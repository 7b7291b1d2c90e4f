#include "protocol/archive/read_connection.hpp"

#include <SQLiteCpp/Exception.h>
#include <sqlite3.h>
#include <string>
#include <sys/stat.h>
#include <utility>

namespace poolhall::protocol {

namespace {

constexpr int kBusyTimeoutMs = 2000;
constexpr int kTries = 5;

/// Opens write-ahead logs for reading only: SQLite's own function makes one that a server has just
/// removed, even for a database that is opened for reading.
int open_no_log_for_writing(sqlite3_vfs* vfs, const char* name, sqlite3_file* file, int flags,
                            int* flags_out) {
    if ((flags & SQLITE_OPEN_WAL) != 0) {
        flags &= ~(SQLITE_OPEN_CREATE | SQLITE_OPEN_READWRITE);
        flags |= SQLITE_OPEN_READONLY;
    }
    // The function is the same for all of SQLite's systems for Unix.
    return sqlite3_vfs_find("unix")->xOpen(vfs, name, file, flags, flags_out);
}

constexpr const char* kLocking = "poolhall-reader";
constexpr const char* kAlone = "poolhall-reader-alone";  ///< without locks

/// Like one of SQLite's own, but for logs.
sqlite3_vfs reader_of(const char* base, const char* name) {
    sqlite3_vfs vfs = *sqlite3_vfs_find(base);
    vfs.pNext = nullptr;
    vfs.zName = name;
    vfs.xOpen = open_no_log_for_writing;
    return vfs;
}

void register_once() {
    static sqlite3_vfs locking = reader_of("unix", kLocking);
    static sqlite3_vfs alone = reader_of("unix-none", kAlone);
    static const int registered =
        sqlite3_vfs_register(&locking, 0) | sqlite3_vfs_register(&alone, 0);
    static_cast<void>(registered);
}

std::string uri_of(const std::filesystem::path& path) {
    std::string uri = "file:";
    for (const char byte : path.string()) {
        if (byte == '%' || byte == '?' || byte == '#') {
            uri += byte == '%' ? "%25" : byte == '?' ? "%3f" : "%23";
        } else {
            uri += byte;
        }
    }
    return uri;
}

}  // namespace

ReadConnection::ReadConnection(std::filesystem::path path) : path_(std::move(path)) {
    register_once();
    for (int tries = 1;; ++tries) {
        stamp_ = stamp();
        try {
            open_once();
            return;
        } catch (const SQLite::Exception&) {
            // A server that begins or ends makes or removes the log and its index meanwhile.
            if (tries == kTries || stamp_ == stamp()) throw;
        }
    }
}

bool ReadConnection::is_current() const {
    return sees_writers_ || stamp_ == stamp();
}

void ReadConnection::open_once() {
    const std::int64_t log_size = stamp_[4];

    struct stat index {};

    sees_writers_ = log_size > 0 && ::stat((path_.string() + "-shm").c_str(), &index) == 0;
    if (log_size == 0) {
        connect(kLocking, "immutable=1");
    } else if (sees_writers_) {
        connect(kLocking, "readonly_shm=1");
    } else {
        connect(kAlone, "mode=ro");
        database_->exec("PRAGMA locking_mode = EXCLUSIVE");  // then SQLite wants no index file
    }
    // Only a first read opens the log.
    static_cast<void>(database_->execAndGet("PRAGMA user_version"));
}

void ReadConnection::connect(const char* vfs, const char* parameter) {
    const std::string uri = uri_of(path_) + "?vfs=" + vfs + "&" + parameter;
    database_ = std::make_unique<SQLite::Database>(uri, SQLite::OPEN_READONLY | SQLite::OPEN_URI,
                                                   kBusyTimeoutMs);
    sqlite3_db_config(database_->getHandle(), SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
}

ReadConnection::Stamp ReadConnection::stamp() const {
    constexpr std::int64_t kNsPerS = 1'000'000'000;
    Stamp result{};
    std::size_t at = 0;
    for (const char* suffix : {"", "-wal"}) {
        struct stat file {};

        if (::stat((path_.string() + suffix).c_str(), &file) == 0) {
            result[at] = static_cast<std::int64_t>(file.st_ino);
            result[at + 1] = file.st_size;
            result[at + 2] = file.st_mtim.tv_sec * kNsPerS + file.st_mtim.tv_nsec;
        }
        at += 3;
    }
    return result;
}

}  // namespace poolhall::protocol
