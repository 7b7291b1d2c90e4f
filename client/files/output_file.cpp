#include "client/files/output_file.hpp"

#include "client/files/descriptor.hpp"

#include <cerrno>
#include <fcntl.h>
#include <random>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace poolhall::files {

namespace fs = std::filesystem;

namespace {

constexpr int kMaxLinks = 40;  ///< as many as Linux follows
constexpr mode_t kPermissions = 07777;
constexpr mode_t kOwnersPermissions = 0700;
/// Leaves room for what is added, where names may have 255 bytes.
constexpr std::size_t kMaxStemBytes = 200;

/// Links of /proc lead to what a process has open, whatever path they show.
bool is_in_proc(const fs::path& link) {
    std::error_code unknown;
    const fs::path folder = fs::canonical(fs::absolute(link, unknown).parent_path(), unknown);
    return !unknown && folder.string().starts_with("/proc/");
}

/// Where links lead to, be there something or not; the path itself if it leads through /proc.
fs::path follow(fs::path path, std::error_code& error) {
    for (int links = 0; links < kMaxLinks; ++links) {
        std::error_code none;
        if (!fs::is_symlink(path, none) || is_in_proc(path)) return path;
        const fs::path next = fs::read_symlink(path, error);
        if (error) return path;
        path = next.is_absolute() ? next : path.parent_path() / next;
    }
    error = std::make_error_code(std::errc::too_many_symbolic_link_levels);
    return path;
}

fs::path beside(const fs::path& target) {
    constexpr const char* kDigits = "0123456789abcdef";
    std::random_device random;
    std::string name = target.filename().string().substr(0, kMaxStemBytes) + '.';
    for (int i = 0; i < 8; ++i)
        name += kDigits[random() % 16];
    return target.parent_path() / (name + ".part");
}

/// Gives a new file the owner of an older one, and of its mode the permissions.
bool take_after(const Descriptor& file, const struct stat& older, mode_t permissions) {
    struct stat own {};

    if (::fstat(file.number(), &own) != 0) return false;
    const bool same_owner = own.st_uid == older.st_uid && own.st_gid == older.st_gid;
    if (!same_owner && ::fchown(file.number(), older.st_uid, older.st_gid) != 0) return false;
    return ::fchmod(file.number(), older.st_mode & permissions) == 0;
}

bool reach_disk(const fs::path& path) {
    const Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
    return file.is_open() && ::fsync(file.number()) == 0;
}

}  // namespace

OutputFile::OutputFile(fs::path file, Readers readers) : file_(std::move(file)), readers_(readers) {
    open();
}

OutputFile::~OutputFile() {
    stream_.close();
    std::error_code ignored;
    if (!unfinished_.empty()) fs::remove(unfinished_, ignored);
}

void OutputFile::open() {
    std::error_code error;
    target_ = follow(file_, error);
    if (error) return note_fault(error.value());

    struct stat older {};

    if (::stat(target_.c_str(), &older) != 0) {
        if (errno != ENOENT) return note_fault(errno);
        return open_beside(nullptr);
    }
    std::error_code none;
    if (!S_ISREG(older.st_mode) || fs::is_symlink(target_, none)) return open_as_it_is();
    if (::faccessat(AT_FDCWD, target_.c_str(), W_OK, AT_EACCESS) != 0) return note_fault(errno);
    if (older.st_nlink > 1) {
        in_place_ = true;
    } else {
        open_beside(&older);
    }
}

void OutputFile::open_as_it_is() {
    errno = 0;
    stream_.open(target_, std::ios::binary | std::ios::app);
    if (!stream_) note_fault(errno);
}

/// Where an older file cannot be replaced, it is overwritten.
void OutputFile::open_beside(const struct stat* older) {
    constexpr mode_t kOwnerOnly = 0600;
    constexpr mode_t kNew = 0666;  // less the umask
    const bool secret = readers_ == Readers::kOwnerOnly;
    const fs::path part = beside(target_);
    const Descriptor made(::open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC,
                                 older != nullptr || secret ? kOwnerOnly : kNew));
    if (!made.is_open()) {
        if (older == nullptr) return note_fault(errno);
        in_place_ = true;
        return;
    }
    unfinished_ = part;
    if (older != nullptr && !take_after(made, *older, secret ? kOwnersPermissions : kPermissions)) {
        in_place_ = true;
        std::error_code ignored;
        fs::remove(std::exchange(unfinished_, {}), ignored);
        return;
    }
    errno = 0;
    stream_.open(part, std::ios::binary);
    if (!stream_) note_fault(errno);
}

void OutputFile::finish() {
    if (fault_) return;
    if (in_place_) return overwrite();
    if (close_stream() && !unfinished_.empty()) take_place();
}

bool OutputFile::close_stream() {
    const bool whole = stream_.good();
    errno = 0;
    if (!whole) {
        // What failed earlier left no reason; it fails once more to tell it.
        stream_.clear();
        stream_ << '\n' << std::flush;
    }
    stream_.close();
    if (whole && stream_) return true;
    note_fault(errno);
    return false;
}

void OutputFile::take_place() {
    errno = 0;
    if (!reach_disk(unfinished_)) return note_fault(errno);
    std::error_code error;
    fs::rename(unfinished_, target_, error);
    if (error) return note_fault(error.value());
    unfinished_.clear();
}

void OutputFile::overwrite() {
    const std::string text = memory_.str();
    const auto size = static_cast<off_t>(text.size());

    struct stat older {};

    const Descriptor file(::open(target_.c_str(), O_WRONLY | O_CLOEXEC));
    if (!file.is_open() || ::fstat(file.number(), &older) != 0) return note_fault(errno);
    if (size > older.st_size) {
        const int error = ::posix_fallocate(file.number(), 0, size);
        if (error != 0) {
            // Nothing of the older one has been touched, but it may have grown.
            static_cast<void>(::ftruncate(file.number(), older.st_size));
            return note_fault(error);
        }
    }
    const bool written = file.write(text) && ::ftruncate(file.number(), size) == 0;
    if (!written || ::fsync(file.number()) != 0) note_fault(errno);
}

void OutputFile::note_fault(int error) {
    fault_ = file_.string() + " cannot be written";
    if (error != 0) *fault_ += ": " + std::generic_category().message(error);
}

}  // namespace poolhall::files
