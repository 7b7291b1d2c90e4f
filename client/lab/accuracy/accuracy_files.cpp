#include "client/lab/accuracy/accuracy_files.hpp"

#include <cerrno>
#include <cstring>
#include <system_error>

namespace poolhall::lab {

AccuracyFiles::AccuracyFiles(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) {
        fault_ = folder.string() + " cannot be made: " + error.message();
        return;
    }
    open(json_, folder / "accuracy.json");
    if (!fault_) open(csv_, folder / "accuracy.csv");
}

AccuracyFiles::~AccuracyFiles() {
    std::error_code ignored;
    for (Output* output : {&json_, &csv_}) {
        output->stream.close();
        if (!output->part.empty()) std::filesystem::remove(output->part, ignored);
    }
}

void AccuracyFiles::write(const AccuracyResult& result) {
    write_json(json_.stream, result);
    write_csv(csv_.stream, result);
    finish(json_);
    finish(csv_);
}

void AccuracyFiles::open(Output& output, const std::filesystem::path& file) {
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

void AccuracyFiles::finish(Output& output) {
    output.stream.close();
    std::error_code error;
    if (output.stream) std::filesystem::rename(output.part, output.file, error);
    if (!output.stream || error) fault_ = output.file.string() + " cannot be written";
}

}  // namespace poolhall::lab
