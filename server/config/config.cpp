#include "server/config/config.hpp"

#include "server/base/identity.hpp"
#include "server/config/toml_file.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <optional>
#include <string_view>
#include <thread>
#include <utility>

namespace poolhall::server {
namespace {

using Field = std::variant<std::string ServerConfig::*, std::uint32_t ServerConfig::*,
                           std::vector<std::string> ServerConfig::*>;

/// The list that flags, environment, file and help are made from.
struct Setting {
    std::string_view
        name;  ///< "max-matches": flag --max-matches, key max-matches, POOLHALL_MAX_MATCHES
    std::string_view type;
    std::string_view help;
    Field field;
    std::uint32_t least = 0;  ///< for numbers
    std::uint32_t most = 0;
};

const std::array kSettings{
    Setting{"listen", "ADDR:PORT", "Where to listen; port 0 takes a free one",
            &ServerConfig::listen},
    Setting{"data", "DIR", "Folder of the replay store", &ServerConfig::data},
    Setting{"threads", "N", "Threads that serve; by default the number of cores, at most 4",
            &ServerConfig::threads, 1, 64},
    Setting{"max-matches", "N", "Matches open at once", &ServerConfig::max_matches, 1, 1'000'000},
    Setting{"max-spectators", "N", "Spectators of one match", &ServerConfig::max_spectators, 0,
            1'000'000},
    Setting{"max-sessions", "N", "WebSocket sessions at once", &ServerConfig::max_sessions, 1,
            1'000'000},
    Setting{
        "max-per-address", "N",
        "Connections of one address (IPv6: of one /64) at once, 0 for no bound, as behind a proxy",
        &ServerConfig::max_per_address, 0, 1'000'000},
    Setting{"idle-timeout", "SECONDS", "A match with nobody connected is closed after this",
            &ServerConfig::idle_timeout, 1, 31'536'000},
    Setting{"log-level", "LEVEL", "trace, debug, info, warn, error or off",
            &ServerConfig::log_level},
    Setting{"allow-origin", "ORIGIN",
            "Origin of web pages that may connect, * for all; may be given again",
            &ServerConfig::allow_origin},
};

std::string environment_name(std::string_view name) {
    std::string text = "POOLHALL_";
    for (const char c : name)
        text += c == '-' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
}

const Setting* find_setting(std::string_view name) {
    const auto found = std::find_if(kSettings.begin(), kSettings.end(),
                                    [&](const Setting& setting) { return setting.name == name; });
    return found == kSettings.end() ? nullptr : &*found;
}

ConfigExit usage_error(const std::string& line) {
    return {2, "poolhall-server: " + line};
}

// ---- the file

std::string range_of(const Setting& setting) {
    return "must be a whole number from " + std::to_string(setting.least) + " to " +
           std::to_string(setting.most);
}

/// Sets the field from the file's value; the answer is what is wrong with it.
std::optional<std::string> apply(ServerConfig& config, const Setting& setting,
                                 const TomlSetting& given) {
    if (const auto* number = std::get_if<std::uint32_t ServerConfig::*>(&setting.field)) {
        const auto* value = std::get_if<std::int64_t>(&given.value);
        if (!value || *value < setting.least || *value > setting.most) return range_of(setting);
        config.*(*number) = static_cast<std::uint32_t>(*value);
    } else if (const auto* text = std::get_if<std::string ServerConfig::*>(&setting.field)) {
        const auto* value = std::get_if<std::string>(&given.value);
        if (!value) return "must be a string";
        config.*(*text) = *value;
    } else if (const auto* list =
                   std::get_if<std::vector<std::string> ServerConfig::*>(&setting.field)) {
        const auto* value = std::get_if<std::vector<std::string>>(&given.value);
        if (!value) return "must be an array of strings";
        config.*(*list) = *value;
    }
    return std::nullopt;
}

/// Reads the file; what flags or the environment have set stays.
std::optional<ConfigExit> apply_file(ServerConfig& config, const std::string& path,
                                     const CLI::App& app) {
    const auto settings = read_toml(path);
    if (!settings) return usage_error(settings.error());
    for (const TomlSetting& given : *settings) {
        const std::string where = path + ":" + std::to_string(given.line) + ": ";
        const Setting* setting = find_setting(given.key);
        if (!setting) return usage_error(where + "unknown key '" + given.key + "'");
        ServerConfig trial = config;
        if (const auto fault = apply(trial, *setting, given))
            return usage_error(where + given.key + " " + *fault);
        if (app.get_option("--" + given.key)->count() == 0) config = std::move(trial);
    }
    return std::nullopt;
}

// ---- flags and environment

void add_option(CLI::App& app, ServerConfig& config, const Setting& setting) {
    const std::string flag = "--" + std::string(setting.name);
    CLI::Option* option = nullptr;
    if (const auto* number = std::get_if<std::uint32_t ServerConfig::*>(&setting.field)) {
        option = app.add_option(flag, config.*(*number), std::string(setting.help));
        option->check(CLI::Range(setting.least, setting.most));
    } else if (const auto* text = std::get_if<std::string ServerConfig::*>(&setting.field)) {
        option = app.add_option(flag, config.*(*text), std::string(setting.help));
    } else if (const auto* list =
                   std::get_if<std::vector<std::string> ServerConfig::*>(&setting.field)) {
        option = app.add_option(flag, config.*(*list), std::string(setting.help))
                     ->allow_extra_args(false);
    }
    option->type_name(std::string(setting.type))
        ->capture_default_str()
        ->envname(environment_name(setting.name));
}

std::uint32_t default_threads() {
    return std::clamp(std::thread::hardware_concurrency(), 1U, 4U);
}

/// What flags, environment and file have in common.
std::optional<std::string> find_fault(const ServerConfig& config) {
    constexpr std::array<std::string_view, 6> kLevels{"trace", "debug", "info",
                                                      "warn",  "error", "off"};
    if (std::find(kLevels.begin(), kLevels.end(), config.log_level) == kLevels.end())
        return "log-level is '" + config.log_level +
               "': it must be trace, debug, info, warn, error or off";
    if (config.data.empty()) return "data must name a folder";
    return std::nullopt;
}

}  // namespace

Result<ServerConfig, ConfigExit> load_config(int argc, const char* const* argv) {
    ServerConfig config;
    config.threads = default_threads();
    std::string file;
    CLI::App app("Serves matches of pool to players and spectators, and logs every shot.",
                 "poolhall-server");
    app.set_version_flag("--version", std::string(kServerName));
    app.add_option(
           "--config", file,
           "TOML file with these settings, - for standard input; flags and environment come "
           "before it")
        ->type_name("FILE")
        ->envname("POOLHALL_CONFIG");
    for (const Setting& setting : kSettings)
        add_option(app, config, setting);
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        return ConfigExit{0, app.help()};
    } catch (const CLI::CallForVersion&) {
        return ConfigExit{0, std::string(kServerName) + "\n"};
    } catch (const CLI::ParseError& error) {
        return usage_error(error.what());
    }
    if (!file.empty())
        if (auto exit = apply_file(config, file, app)) return *exit;
    if (const auto fault = find_fault(config)) return usage_error(*fault);
    return config;
}

}  // namespace poolhall::server
