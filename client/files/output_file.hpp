#pragma once

#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <sys/stat.h>

namespace poolhall::files {

/// A file that is written whole or not at all: until it is finished, an older one of the name stays
/// as it is.
///
/// - A symbolic link stays one, and so does a chain of them: its target is written, and made if it
///   is not there.
/// - A new file is written beside its place, as FILE.XXXXXXXX.part, and takes it when it is whole
///   and on the disk; a .part is gone again if it is never finished. The mode and owner of an older
///   file are kept. One that this process may not write is left alone.
/// - Where an older file cannot be replaced so (its folder cannot be written, it belongs to another
///   user, it has further hard links), its content is kept in memory and overwritten at the end,
///   after space for all of it has been had: a full disk changes nothing, only a crash in that
///   moment does.
/// - What is no ordinary file (/dev/stdout, /dev/null, a pipe) is written as it is, at its end.
class OutputFile {
  public:
    enum class Readers { kAsUsual, kOwnerOnly };

    /// Opens it, so that a long run can begin with knowing that it can be written. kOwnerOnly: what
    /// is secret; nobody else may read it, even if others could read an older one.
    explicit OutputFile(std::filesystem::path file, Readers readers = Readers::kAsUsual);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return file_; }

    [[nodiscard]] std::ostream& stream() {
        return in_place_ ? static_cast<std::ostream&>(memory_) : stream_;
    }

    /// Nothing is written after this.
    void finish();

    /// "a/b.csv cannot be written: No space left on device"; nothing if all went well so far.
    [[nodiscard]] const std::optional<std::string>& fault() const { return fault_; }

  private:
    void open();
    void open_as_it_is();
    void open_beside(const struct stat* older);
    bool close_stream();
    void take_place();
    void overwrite();
    void note_fault(int error);

    std::filesystem::path file_;
    Readers readers_;
    std::filesystem::path target_;      ///< file_, its links followed
    std::filesystem::path unfinished_;  ///< empty once there is none
    std::ofstream stream_;
    bool in_place_ = false;  ///< memory_ holds what is to be written over the target
    std::ostringstream memory_;
    std::optional<std::string> fault_;
};

}  // namespace poolhall::files
