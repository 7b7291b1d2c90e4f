#include "client/replay/commands.hpp"

#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>

namespace {

using namespace poolhall::client;

/// What the command line asks for.
struct Options {
    std::string data = "data";
    ReplayChoice choice;
    std::string export_file;
    bool json = false;
    bool all = false;
};

CLI::App* add_command(CLI::App& app, const std::string& name, const std::string& does) {
    CLI::App* command = app.add_subcommand(name, does);
    command->fallthrough();  // --data may stand after the command
    return command;
}

/// Adds ID and --file, of which one must be given.
CLI::Option_group* add_choice(CLI::App* command, Options& options) {
    CLI::Option_group* group = command->add_option_group("replay", "Which replay; one of");
    group->add_option("ID", options.choice.id, "A match of the replay store");
    group->add_option("--file", options.choice.file, "An exported file, - for standard input");
    group->require_option(1);
    return group;
}

Status run(const CLI::App& app, const Options& options) {
    const ReplayTool tool{options.data, std::cin, std::cout, std::cerr};
    if (app.got_subcommand("list")) return list_replays(tool);
    if (app.got_subcommand("export"))
        return export_replay(tool, options.choice.id, options.export_file);
    if (app.got_subcommand("verify"))
        return options.all ? verify_all(tool) : verify_replay(tool, options.choice);
    return show_replay(tool, options.choice, options.json ? ShowForm::kJson : ShowForm::kTable);
}

int run_program(int argc, char** argv) {
    Options options;
    CLI::App app(
        "Lists, shows, verifies and exports the replays of a Poolhall server.\n"
        "Exit status: 0 fine, 1 a shot diverged, 2 bad input.",
        "poolhall-replay");
    app.require_subcommand(1);
    app.add_option("--data", options.data, "Folder of the replay store")
        ->envname("POOLHALL_DATA")
        ->capture_default_str();
    add_command(app, "list", "List all replays, newest first");
    CLI::App* show = add_command(app, "show", "Print a replay");
    add_choice(show, options);
    show->add_flag("--json", options.json, "The records, one JSON object a line");
    CLI::App* verify = add_command(app, "verify", "Simulate every shot again and compare");
    add_choice(verify, options)->add_flag("--all", options.all, "Every replay of the store");
    CLI::App* exporting = add_command(app, "export", "Write a replay as JSON Lines");
    exporting->add_option("ID", options.choice.id, "A match of the replay store")->required();
    exporting->add_option("FILE", options.export_file, "- for standard output")->required();
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : static_cast<int>(Status::kBadInput);
    }
    const Status status = run(app, options);
    if (std::cout.flush()) return static_cast<int>(status);
    std::cerr << "poolhall-replay: standard output cannot be written\n";
    return static_cast<int>(Status::kBadInput);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run_program(argc, argv);
    } catch (const std::exception& error) {
        std::cerr << "poolhall-replay: " << error.what() << '\n';
        return static_cast<int>(Status::kBadInput);
    }
}
