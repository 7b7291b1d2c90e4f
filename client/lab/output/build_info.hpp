#pragma once

#include <string>

// What every table of measurements must say of itself.
namespace poolhall::lab {

struct BuildInfo {
    std::string compiler;   ///< name and version
    std::string flags;      ///< that bear on speed
    std::string processor;  ///< model name, or "unknown"
};

/// Of this program, on this machine.
[[nodiscard]] BuildInfo build_info();

}  // namespace poolhall::lab
