#pragma once

#include "client/desktop/net/server_address.hpp"
#include "protocol/codec/codec.hpp"
#include "shared/game/settings.hpp"
#include "shared/result.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace poolhall::client {

/// What the command line asks for.
struct Options {
    std::optional<ServerAddress> server;  ///< none: practice, alone and offline
    std::string code;                     ///< as normalize_code gives it; empty: a new match
    bool watch = false;
    GameSettings settings;  ///< of a match or practice that begins here
    std::string name;
    protocol::Encoding encoding = protocol::Encoding::kJson;
    std::filesystem::path screenshots = ".";  ///< folder
    int width = 1280;                         ///< of the window, in points
    int height = 720;
};

/// Why the program ends at once: help was asked for, or the command line is wrong.
struct EarlyExit {
    int status = 0;
    std::string text;  ///< for standard output when status is 0, else one line for standard error
};

/// Also reads the file that --physics names.
[[nodiscard]] Result<Options, EarlyExit> parse_options(int argc, const char* const* argv);

}  // namespace poolhall::client
