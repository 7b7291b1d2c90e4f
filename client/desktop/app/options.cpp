#include "client/desktop/app/options.hpp"

#include "client/desktop/app/physics_file.hpp"
#include "client/desktop/view/layout.hpp"
#include "protocol/intake/person_name.hpp"
#include "protocol/text.hpp"
#include "shared/game/end_game.hpp"

#include <CLI/CLI.hpp>
#include <cstdlib>

namespace poolhall::client {
namespace {

/// The command line as typed, before anything is made of it.
struct Typed {
    std::string server;
    std::string match;
    std::string name;
    std::string physics;
    std::string encoding{poolhall::name(protocol::Encoding::kJson)};
    std::string screenshots = ".";
    bool watch = false;
    bool practice = false;
    int width = 1280;
    int height = 720;
};

std::vector<std::string> encoding_names() {
    std::vector<std::string> names;
    for (const protocol::Encoding encoding : kValues<protocol::Encoding>)
        names.emplace_back(name(encoding));
    return names;
}

void declare(CLI::App& app, Typed& typed) {
    app.add_option("--server", typed.server, "server: ws://HOST:PORT or HOST:PORT")
        ->type_name("URL");
    auto* match = app.add_option("--match", typed.match, "join this match, or come back to it")
                      ->type_name("CODE");
    app.add_flag("--watch", typed.watch, "look on instead of playing")->needs(match);
    app.add_option("--name", typed.name, "your name at the table")->type_name("NAME");
    auto* practice = app.add_flag("--practice", typed.practice,
                                  "play alone and offline (the default without a server)");
    practice->excludes("--server")->excludes(match);
    app.add_option(
           "--physics", typed.physics,
           "play with the effects and the solver of this poolhall.scene/1 file; - for standard "
           "input")
        ->type_name("FILE")
        ->excludes(match);
    app.add_option("--encoding", typed.encoding, "of the messages")
        ->check(CLI::IsMember(encoding_names()))
        ->capture_default_str();
    app.add_option("--screenshots", typed.screenshots, "folder for screenshots")
        ->type_name("DIR")
        ->capture_default_str();
    app.add_option("--width", typed.width, "of the window")
        ->check(CLI::Range(kMinWindowWidth, 7680))
        ->capture_default_str();
    app.add_option("--height", typed.height, "of the window")
        ->check(CLI::Range(kMinWindowHeight, 4320))
        ->capture_default_str();
}

EarlyExit bad(const std::string& text) {
    return {2, "poolhall-client: " + text};
}

std::string default_name() {
    const char* user = std::getenv("USER");
    auto name = protocol::person_name(user != nullptr ? user : "");
    return name ? *std::move(name) : "Player";
}

std::string first_line(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

Result<Options, EarlyExit> options_of(const Typed& typed) {
    Options options;
    options.watch = typed.watch;
    options.screenshots = typed.screenshots;
    options.width = typed.width;
    options.height = typed.height;
    options.encoding = find<protocol::Encoding>(typed.encoding).value_or(options.encoding);
    const auto name = protocol::person_name(typed.name.empty() ? default_name() : typed.name);
    if (!name) return bad("--name: " + std::string(name.error().reason));
    options.name = *name;
    if (!typed.physics.empty()) {
        const auto settings = read_physics(typed.physics, kEndGameRules);
        if (!settings) return bad("--physics: " + settings.error());
        options.settings = *settings;
    }
    if (typed.server.empty() && typed.match.empty()) return options;

    const std::string server = typed.server.empty() ? std::string(kDefaultServer) : typed.server;
    options.server = parse_server_address(server);
    if (!options.server)
        return bad("--server: not an address like ws://host:port: " + protocol::shown(server));
    if (typed.match.empty()) return options;
    const auto code = protocol::normalize_code(typed.match);
    if (!code) return bad("--match: not a code like BCD-FGH: " + protocol::shown(typed.match));
    options.code = *code;
    return options;
}

}  // namespace

Result<Options, EarlyExit> parse_options(int argc, const char* const* argv) {
    CLI::App app("Poolhall: play pool, alone or over the network", "poolhall-client");
    Typed typed;
    try {
        declare(app, typed);
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        return EarlyExit{0, app.help()};
    } catch (const CLI::Error& error) {
        return bad(first_line(error.what()));
    }
    return options_of(typed);
}

}  // namespace poolhall::client
