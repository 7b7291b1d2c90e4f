#pragma once

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

namespace poolhall::files {

/// A file that takes the place of an older one only when it is whole. Until then it is FILE.part,
/// which is gone again if it is never finished. What is no ordinary file, such as /dev/stdout, is
/// written as it is.
class OutputFile {
  public:
    /// Opens it, so that a long run can begin with knowing that it can be written.
    explicit OutputFile(std::filesystem::path file);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return file_; }

    [[nodiscard]] std::ostream& stream() { return stream_; }

    /// Nothing is written after this.
    void finish();

    /// "a/b.csv cannot be written: No space left on device"; nothing if all went well so far.
    [[nodiscard]] const std::optional<std::string>& fault() const { return fault_; }

  private:
    void note_fault(int error);

    std::filesystem::path file_;
    std::filesystem::path unfinished_;  ///< empty once there is none
    std::ofstream stream_;
    std::optional<std::string> fault_;
};

}  // namespace poolhall::files
