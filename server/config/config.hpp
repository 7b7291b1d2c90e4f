#pragma once

#include "shared/result.hpp"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace poolhall::server {

struct ServerConfig {
    std::string listen = "127.0.0.1:8080";  ///< ADDR:PORT
    std::string data = "data";              ///< folder of the replay store
    std::uint32_t threads = 1;
    std::uint32_t max_matches = 10000;
    std::uint32_t max_spectators = 1000;  ///< of one match
    std::uint32_t max_sessions = 20000;
    std::uint32_t max_per_address = 1000;  ///< connections of one address (IPv6: /64); 0: no bound
    std::uint32_t idle_timeout = 1800;     ///< s until a match with nobody connected is closed
    std::string log_level = "info";
    std::vector<std::string> allow_origin;  ///< web pages that may connect; empty: the same host's
};

/// What is to be printed instead of serving, and how to exit.
struct ConfigExit {
    int status = 2;
    std::string text;  ///< on standard output if status is 0, else one line for standard error
};

/// Reads the settings: flags over environment (POOLHALL_LISTEN, ...) over the TOML file named by
/// --config. The default of `threads` is the number of cores, at most 4.
[[nodiscard]] Result<ServerConfig, ConfigExit> load_config(int argc, const char* const* argv);

}  // namespace poolhall::server
