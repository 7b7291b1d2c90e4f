#include "client/lab/run/status.hpp"

namespace poolhall::lab {

Status fail(std::ostream& error, const std::string& fault) {
    error << "poolhall-lab: " << fault << '\n';
    return Status::kBadInput;
}

}  // namespace poolhall::lab
