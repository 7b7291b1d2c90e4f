#pragma once

#include "client/lab/accuracy/results.hpp"

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

namespace poolhall::lab {

/// DIR/accuracy.json ("poolhall.accuracy/1", README.md) and DIR/accuracy.csv (a line a point). They
/// are opened before the run, under other names, and take the place of older ones at its end.
class AccuracyFiles {
  public:
    /// Makes the folder if there is none. `fault()` says whether that and all since went well.
    explicit AccuracyFiles(const std::filesystem::path& folder);
    ~AccuracyFiles();
    AccuracyFiles(const AccuracyFiles&) = delete;
    AccuracyFiles& operator=(const AccuracyFiles&) = delete;

    void write(const AccuracyResult& result);

    /// What cannot be written, in a sentence without a full stop; nothing if all is well.
    [[nodiscard]] const std::optional<std::string>& fault() const { return fault_; }

  private:
    struct Output {
        std::filesystem::path file;
        std::filesystem::path part;  ///< until it is complete
        std::ofstream stream;
    };

    void open(Output& output, const std::filesystem::path& file);
    void finish(Output& output);

    Output json_;
    Output csv_;
    std::optional<std::string> fault_;
};

/// The same, to a stream.
void write_json(std::ostream& out, const AccuracyResult& result);
void write_csv(std::ostream& out, const AccuracyResult& result);

}  // namespace poolhall::lab
