#include "client/lab/output/result_files.hpp"

#include <system_error>

namespace poolhall::lab {

ResultFiles::ResultFiles(const std::filesystem::path& folder, const std::string& name) {
    if (folder.empty()) return;
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) {
        fault_ = folder.string() + " cannot be made: " + error.message();
        return;
    }
    json_.emplace(folder / (name + ".json"));
    csv_.emplace(folder / (name + ".csv"));
    fault_ = json_->fault() ? json_->fault() : csv_->fault();
}

void ResultFiles::write(const Write& json, const Write& csv) {
    finish(json_, json);
    finish(csv_, csv);
}

void ResultFiles::finish(std::optional<files::OutputFile>& file, const Write& write) {
    if (!file) return;
    write(file->stream());
    file->finish();
    if (file->fault()) fault_ = file->fault();
}

}  // namespace poolhall::lab
