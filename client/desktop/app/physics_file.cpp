#include "client/desktop/app/physics_file.hpp"

#include "protocol/codec/scene_json.hpp"
#include "protocol/text.hpp"
#include "protocol/tree.hpp"

#include <fstream>
#include <iostream>
#include <istream>
#include <nlohmann/json.hpp>
#include <optional>

namespace poolhall::client {
namespace {

/// Far more than a scene with its 1024 balls takes.
constexpr std::size_t kMaxFileBytes = 1U << 20U;

/// The bytes, up to one more than allowed.
std::string read_some(std::istream& file) {
    std::string text(kMaxFileBytes + 1, '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(file.gcount()));
    return text;
}

/// None if it cannot be read.
std::optional<std::string> read_file(const std::filesystem::path& path) {
    if (path == "-") return read_some(std::cin);
    std::ifstream file(path, std::ios::binary);
    if (!file || std::filesystem::is_directory(path)) return std::nullopt;
    return read_some(file);
}

std::string at(const SceneError& error) {
    return (error.pointer.empty() ? "the scene" : protocol::shown(error.pointer)) + " " +
           error.reason;
}

}  // namespace

Result<GameSettings, std::string> read_physics(const std::filesystem::path& path,
                                               const Ruleset& rules) {
    const std::string file =
        (path == "-" ? "standard input" : protocol::shown(path.string())) + ": ";
    const auto text = read_file(path);
    if (!text) return file + "cannot be read";
    if (text->size() > kMaxFileBytes) return file + "is longer than 1 MiB";
    const auto tree = protocol::parse_tree(*text, protocol::Encoding::kJson);
    if (!tree) return file + "is no JSON: " + tree.error().reason;
    const auto scene = protocol::scene_from_json(*tree);
    if (!scene) return file + at(scene.error());
    const GameSettings settings{scene->effects, scene->solver};
    if (const auto fault = check(rules, settings)) return file + at(*fault);
    return settings;
}

}  // namespace poolhall::client
