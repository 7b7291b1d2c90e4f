#include "client/lab/result_files.hpp"

#include <cerrno>
#include <cstring>
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
    open(json_, folder / (name + ".json"));
    if (!fault_) open(csv_, folder / (name + ".csv"));
}

ResultFiles::~ResultFiles() {
    std::error_code ignored;
    for (Output* output : {&json_, &csv_}) {
        output->stream.close();
        if (!output->part.empty()) std::filesystem::remove(output->part, ignored);
    }
}

void ResultFiles::write(const Write& json, const Write& csv) {
    finish(json_, json);
    finish(csv_, csv);
}

void ResultFiles::open(Output& output, const std::filesystem::path& file) {
    const std::filesystem::path part = file.string() + ".part";
    errno = 0;
    output.stream.open(part);
    if (!output.stream) {
        fault_ = file.string() + " cannot be written: " + std::strerror(errno);
        return;
    }
    output.file = file;
    output.part = part;
}

void ResultFiles::finish(Output& output, const Write& write) {
    if (output.file.empty()) return;
    write(output.stream);
    output.stream.close();
    std::error_code error;
    if (output.stream) std::filesystem::rename(output.part, output.file, error);
    if (!output.stream || error) fault_ = output.file.string() + " cannot be written";
}

}  // namespace poolhall::lab
