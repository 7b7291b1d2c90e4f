#include "server/store/folder_lock.hpp"

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace poolhall::server {

namespace {

constexpr const char* kLockFile = "poolhall.lock";
constexpr mode_t kOwnerOnly = 0600;

std::string reason_of(int error) {
    return std::generic_category().message(error);
}

}  // namespace

Result<FolderLock, FolderLock::Error> FolderLock::take(const std::filesystem::path& folder) {
    const std::filesystem::path path = folder / kLockFile;
    const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, kOwnerOnly);
    if (file < 0) {
        const int error = errno;
        std::error_code unknown;
        // A file that is there was left by a server of another user.
        const bool there = std::filesystem::exists(path, unknown);
        return Error{"cannot write to " + (there ? path : folder).string() + ": " +
                     reason_of(error)};
    }
    FolderLock lock(file);
    if (::flock(file, LOCK_EX | LOCK_NB) == 0) return lock;
    if (errno == EWOULDBLOCK) return Error{folder.string() + " is in use by another server"};
    return Error{"cannot lock " + path.string() + ": " + reason_of(errno)};
}

FolderLock::FolderLock(FolderLock&& other) noexcept : file_(std::exchange(other.file_, -1)) {}

FolderLock& FolderLock::operator=(FolderLock&& other) noexcept {
    std::swap(file_, other.file_);
    return *this;
}

FolderLock::~FolderLock() {
    // The file stays: removing it would let two servers lock two files of the same name.
    if (file_ >= 0) ::close(file_);
}

}  // namespace poolhall::server
