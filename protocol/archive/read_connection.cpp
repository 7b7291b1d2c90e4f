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

int remove_nothing(sqlite3_vfs* /*vfs*/, const char* /*name*/, int /*sync*/) {
    return SQLITE_OK;
}

int lock_nothing(sqlite3_file* /*file*/, int /*lock*/) {
    return SQLITE_OK;
}

int find_no_lock(sqlite3_file* /*file*/, int* held) {
    *held = 0;
    return SQLITE_OK;
}

/// Opens databases whose locks it neither takes nor looks at. (SQLite's own "unix-none" also takes
/// the locks of a server in the same process away, when it closes the file.)
int open_without_locks(sqlite3_vfs* vfs, const char* name, sqlite3_file* file, int flags,
                       int* flags_out) {
    const int code = open_no_log_for_writing(vfs, name, file, flags, flags_out);
    if (code != SQLITE_OK || (flags & SQLITE_OPEN_MAIN_DB) == 0) return code;
    static const sqlite3_io_methods without_locks = [file] {
        sqlite3_io_methods methods = *file->pMethods;
        methods.xLock = lock_nothing;
        methods.xUnlock = lock_nothing;
        methods.xCheckReservedLock = find_no_lock;
        return methods;
    }();
    file->pMethods = &without_locks;
    return code;
}

constexpr const char* kLocking = "poolhall-reader";
constexpr const char* kAlone = "poolhall-reader-alone";  ///< without locks

using Open = decltype(sqlite3_vfs::xOpen);

/// Like SQLite's own, but for how it opens files, and it removes none.
sqlite3_vfs reader(const char* name, Open open) {
    sqlite3_vfs vfs = *sqlite3_vfs_find("unix");
    vfs.pNext = nullptr;
    vfs.zName = name;
    vfs.xOpen = open;
    vfs.xDelete = remove_nothing;
    return vfs;
}

void register_once() {
    static sqlite3_vfs locking = reader(kLocking, open_no_log_for_writing);
    static sqlite3_vfs alone = reader(kAlone, open_without_locks);
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

/// Whether a server keeps the index of the log, which SQLite tells by the server's lock. It is
/// asked of SQLite: who closes a file by himself gives up all the locks of his process on it.
bool index_is_kept(SQLite::Database& database) {
    constexpr int kFirstRegion = 0;
    constexpr int kRegionBytes = 32'768;
    sqlite3_file* file = nullptr;
    sqlite3_file_control(database.getHandle(), "main", SQLITE_FCNTL_FILE_POINTER, &file);
    volatile void* index = nullptr;
    const int code = file->pMethods->xShmMap(file, kFirstRegion, kRegionBytes, 0, &index);
    file->pMethods->xShmUnmap(file, 0);
    if (code == SQLITE_READONLY_CANTINIT || code == SQLITE_BUSY) return false;
    if (code != SQLITE_OK && code != SQLITE_READONLY)
        throw SQLite::Exception(sqlite3_errstr(code), code);
    return true;
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
    sees_writers_ = false;
    if (log_size == 0) {
        connect(kLocking, "immutable=1");
        read_once();
    } else {
        sees_writers_ = open_with_index();
        if (!sees_writers_) open_alone();
    }
}

bool ReadConnection::open_with_index() {
    struct stat index {};

    if (::stat((path_.string() + "-shm").c_str(), &index) != 0) return false;
    connect(kLocking, "readonly_shm=1");
    if (!index_is_kept(*database_)) return false;
    try {
        read_once();
        return true;
    } catch (const SQLite::Exception&) {
        return false;  // It is being made, or the server was killed while it changed it.
    }
}

void ReadConnection::open_alone() {
    connect(kAlone, "mode=ro");
    database_->exec("PRAGMA locking_mode = EXCLUSIVE");  // then SQLite wants no index file
    read_once();
}

void ReadConnection::read_once() {
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
