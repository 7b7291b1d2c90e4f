#include "client/lab/run/run_plan.hpp"

namespace poolhall::lab {

std::string command_line(const std::string& command, const RunPlan& plan) {
    std::string line = "poolhall-lab " + command;
    if (plan.quick) line += " --quick";
    if (plan.shots > 0) line += " --shots " + std::to_string(plan.shots);
    return line + " --seed " + std::to_string(plan.seed);
}

}  // namespace poolhall::lab
