#include "server/config/toml_file.hpp"

#include <algorithm>
#include <fstream>
#include <iostream>
#include <optional>
#include <sstream>
#include <string_view>
#include <toml++/toml.h>
#include <utility>

namespace poolhall::server {
namespace {

decltype(TomlSetting::value) value_of(const toml::node& node) {
    if (const auto text = node.value_exact<std::string>()) return *text;
    if (const auto number = node.value_exact<std::int64_t>()) return *number;
    if (!node.is_array()) return std::monostate{};
    std::vector<std::string> list;
    for (const toml::node& item : *node.as_array()) {
        const auto text = item.value_exact<std::string>();
        if (!text) return std::monostate{};
        list.push_back(*text);
    }
    return list;
}

std::optional<std::string> read_text(const std::string& path) {
    std::ostringstream text;
    if (path == "-") {
        text << std::cin.rdbuf();
        return text.str();
    }
    std::ifstream file(path, std::ios::binary);
    if (!file || !(text << file.rdbuf())) return std::nullopt;
    return text.str();
}

}  // namespace

Result<std::vector<TomlSetting>, std::string> read_toml(const std::string& path) {
    const auto text = read_text(path);
    if (!text) return path + ": cannot be read";
    try {
        std::vector<TomlSetting> settings;
        for (const auto& [key, node] : toml::parse(*text, path))
            settings.push_back({std::string(key.str()), value_of(node), node.source().begin.line});
        std::sort(settings.begin(), settings.end(),
                  [](const auto& a, const auto& b) { return a.line < b.line; });
        return settings;
    } catch (const toml::parse_error& error) {
        return path + ":" + std::to_string(error.source().begin.line) + ": " +
               std::string(error.description());
    }
}

}  // namespace poolhall::server
