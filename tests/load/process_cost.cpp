#include "tests/load/process_cost.hpp"

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace poolhall::load {

double cpu_seconds(pid_t process) {
    double total = 0;
    for (const auto& thread :
         std::filesystem::directory_iterator("/proc/" + std::to_string(process) + "/task")) {
        std::ifstream file(thread.path() / "schedstat");
        double nanoseconds = 0;
        if (file >> nanoseconds) total += nanoseconds * 1e-9;
    }
    return total;
}

double resident_bytes(pid_t process) {
    std::ifstream file("/proc/" + std::to_string(process) + "/status");
    for (std::string word; file >> word;) {
        double kibibytes = 0;
        if (word == "VmRSS:" && file >> kibibytes) return kibibytes * 1024;
    }
    throw std::runtime_error("the process is gone");
}

}  // namespace poolhall::load
