#pragma once

#include "shared/result.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace poolhall::server {

/// A setting of a TOML file, and where it stands.
struct TomlSetting {
    std::string key;
    std::variant<std::monostate, std::string, std::int64_t, std::vector<std::string>>
        value;  ///< monostate: another type
    std::size_t line = 0;
};

/// The settings at the top of the file, in its order. The error is one line with file and line.
[[nodiscard]] Result<std::vector<TomlSetting>, std::string> read_toml(const std::string& path);

}  // namespace poolhall::server
