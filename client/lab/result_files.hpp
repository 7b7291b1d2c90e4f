#pragma once

#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <string>

namespace poolhall::lab {

/// FOLDER/NAME.json and FOLDER/NAME.csv. They are opened before a long run, under other names, and
/// take the place of older ones at its end.
class ResultFiles {
  public:
    /// Makes the folder if there is none; without a folder ("") there are no files, and all is
    /// well. `fault()` says whether that and all since went well.
    ResultFiles(const std::filesystem::path& folder, const std::string& name);
    ~ResultFiles();
    ResultFiles(const ResultFiles&) = delete;
    ResultFiles& operator=(const ResultFiles&) = delete;

    using Write = std::function<void(std::ostream& out)>;
    void write(const Write& json, const Write& csv);

    /// What cannot be written, in a sentence without a full stop; nothing if all is well.
    [[nodiscard]] const std::optional<std::string>& fault() const { return fault_; }

  private:
    struct Output {
        std::filesystem::path file;  ///< empty: none is wanted
        std::filesystem::path part;  ///< until it is complete
        std::ofstream stream;
    };

    void open(Output& output, const std::filesystem::path& file);
    void finish(Output& output, const Write& write);

    Output json_;
    Output csv_;
    std::optional<std::string> fault_;
};

}  // namespace poolhall::lab
