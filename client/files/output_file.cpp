#include "client/files/output_file.hpp"

#include <cerrno>
#include <system_error>
#include <utility>

namespace poolhall::files {

namespace fs = std::filesystem;

OutputFile::OutputFile(fs::path file) : file_(std::move(file)) {
    std::error_code unknown;
    const fs::file_status status = fs::status(file_, unknown);
    const bool ordinary = !fs::exists(status) || fs::is_regular_file(status);
    const fs::path opened = ordinary ? fs::path(file_.string() + ".part") : file_;
    errno = 0;
    stream_.open(opened, std::ios::binary);
    if (!stream_) {
        note_fault(errno);
    } else if (ordinary) {
        unfinished_ = opened;
    }
}

OutputFile::~OutputFile() {
    stream_.close();
    std::error_code ignored;
    if (!unfinished_.empty()) fs::remove(unfinished_, ignored);
}

void OutputFile::finish() {
    if (fault_) return;
    const bool whole = stream_.good();
    errno = 0;
    if (!whole) {
        // What failed earlier left no reason; it fails once more to tell it.
        stream_.clear();
        stream_ << '\n' << std::flush;
    }
    stream_.close();
    if (!whole || !stream_) {
        note_fault(errno);
        return;
    }
    if (unfinished_.empty()) return;
    std::error_code error;
    fs::rename(unfinished_, file_, error);
    if (error) {
        note_fault(error.value());
    } else {
        unfinished_.clear();
    }
}

void OutputFile::note_fault(int error) {
    fault_ = file_.string() + " cannot be written";
    if (error != 0) *fault_ += ": " + std::generic_category().message(error);
}

}  // namespace poolhall::files
