#pragma once

#include "client/files/output_file.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace poolhall::lab {

/// FOLDER/NAME.json and FOLDER/NAME.csv of a long run: opened before it, in their places after it.
class ResultFiles {
  public:
    /// Makes the folder if there is none; without a folder ("") there are no files, and all is
    /// well. `fault()` says whether that and all since went well.
    ResultFiles(const std::filesystem::path& folder, const std::string& name);

    using Write = std::function<void(std::ostream& out)>;
    void write(const Write& json, const Write& csv);

    /// What cannot be written, in a sentence without a full stop; nothing if all is well.
    [[nodiscard]] const std::optional<std::string>& fault() const { return fault_; }

  private:
    void finish(std::optional<files::OutputFile>& file, const Write& write);

    std::optional<files::OutputFile> json_;
    std::optional<files::OutputFile> csv_;
    std::optional<std::string> fault_;
};

}  // namespace poolhall::lab
