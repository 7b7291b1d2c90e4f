#include "client/lab/output/build_info.hpp"

#include <fstream>

namespace poolhall::lab {
namespace {

std::string processor() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
    }
    return "unknown";
}

}  // namespace

BuildInfo build_info() {
    return {POOLHALL_COMPILER, POOLHALL_FLAGS, processor()};
}

}  // namespace poolhall::lab
