#include "client/lab/run/long_run.hpp"

namespace poolhall::lab {

void print_head(std::ostream& out, const std::string& command, const BuildInfo& build) {
    out << command << "\ncompiler   " << build.compiler << "\nflags      " << build.flags
        << "\nprocessor  " << build.processor << std::endl;
}

Status say_interrupted(std::ostream& error, const std::string& folder) {
    error << "poolhall-lab: interrupted; what was finished is "
          << (folder.empty() ? "above" : "in " + folder) << '\n';
    return Status::kInterrupted;
}

}  // namespace poolhall::lab
