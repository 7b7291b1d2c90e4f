#include "client/lab/accuracy/accuracy_command.hpp"
#include "client/lab/bench/bench_command.hpp"
#include "client/lab/compare/compare_command.hpp"
#include "client/lab/effects/effects_command.hpp"
#include "client/lab/input/solver_option.hpp"
#include "client/lab/simulate/simulate_command.hpp"

#include <CLI/CLI.hpp>
#include <charconv>
#include <csignal>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace {

using namespace poolhall::lab;

/// What the command line asks for.
struct Options {
    SimulateOptions simulate;
    CompareOptions compare;
    AccuracyOptions accuracy;
    EffectsOptions effects;
    std::string file = "-";
    std::string csv;
};

/// The text as a number; nothing if it is none, has more, or is out of range.
template <class Number>
std::optional<Number> number_in(const std::string& text) {
    Number number{};
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    return error == std::errc{} && stop == end ? std::optional(number) : std::nullopt;
}

/// Empty for a rate of samples, HZ. CLI11's own range lets NaN through.
std::string fault_of_rate(const std::string& text) {
    const auto hz = number_in<double>(text);
    const bool good = hz && *hz > 0 && *hz <= poolhall::kMaxSolverHz;
    return good ? "" : "must be a number above 0, up to 1e6";
}

/// Empty for a seed. CLI11's own range takes -1 for the largest.
std::string fault_of_seed(const std::string& text) {
    return number_in<std::uint64_t>(text) ? "" : "must be a whole number from 0, below 2^64";
}

/// A solver as CLI11 reads it.
poolhall::SolverSpec read_solver(const std::string& text) {
    if (const auto solver = parse_solver(text)) return *solver;
    throw CLI::ValidationError("--solver",
                               "must be event, or euler, semi_implicit, exact_arc or overlap with "
                               "ticks a second (euler:30), not " +
                                   text);
}

void add_solver(CLI::App* command, SimulateOptions& options) {
    const auto read = [&options](const std::string& text) { options.solver = read_solver(text); };
    command->add_option_function<std::string>("--solver", read, "Instead of the scenes' own")
        ->type_name("KIND[:HZ]");
}

void add_compare(CLI::App& app, CompareOptions& options) {
    CLI::App* command = app.add_subcommand(
        "compare", "One scene by several solvers: events side by side, distances, cost, a drawing");
    const auto read = [&options](const std::vector<std::string>& texts) {
        for (const std::string& text : texts)
            options.solvers.push_back(read_solver(text));
    };
    command
        ->add_option_function<std::vector<std::string>>(
            "--solver", read, "Any number; else event, euler:30, euler:120 and overlap:30")
        ->type_name("KIND[:HZ]")
        ->allow_extra_args(false);
    command->add_option("--out", options.out, "Also draws DIR/compare.svg and DIR/compare.png")
        ->type_name("DIR");
    command->add_option("--picture", options.picture, "Also draws this one; ends in .svg or .png")
        ->type_name("FILE");
    command->add_option("SCENE", options.file, "- for standard input")->capture_default_str();
}

void add_simulate(CLI::App& app, Options& options) {
    CLI::App* command = app.add_subcommand(
        "simulate", "Scenes in, JSON Lines or one object; a result a line out, in the same order");
    add_solver(command, options.simulate);
    const auto hex = [&options](std::int64_t) {
        options.simulate.numbers = poolhall::protocol::Numbers::kHexFloat;
    };
    command->add_flag_function("--hex", hex, "Numbers as C hex-floats, bit for bit");
    command
        ->add_option("--sample", options.simulate.sample_hz, "Adds the balls' places, HZ a second")
        ->check(fault_of_rate)
        ->type_name("HZ");
    command->add_option("FILE", options.file, "- for standard input")->capture_default_str();
}

void add_plan(CLI::App* command, RunPlan& plan) {
    command->add_option("--shots", plan.shots, "Of each part; else as many as suit it")
        ->check(CLI::Range(std::size_t{1}, std::size_t{1'000'000}))
        ->type_name("N");
    command->add_option("--seed", plan.seed, "Other shots of the same kinds")
        ->check(fault_of_seed)
        ->type_name("N")
        ->capture_default_str();
}

void add_accuracy(CLI::App& app, AccuracyOptions& options) {
    CLI::App* command = app.add_subcommand(
        "accuracy", "What accuracy costs in time: errors and CPU time of every solver and rate");
    command->add_flag("--quick", options.plan.quick, "Fewer shots and rates: under a minute");
    add_plan(command, options.plan);
    command->add_option("--out", options.out, "Also writes DIR/accuracy.csv and DIR/accuracy.json")
        ->type_name("DIR");
    command->add_option("--only", options.only, "Only this part; any number of them")
        ->check(CLI::IsMember(parts_of_accuracy()))
        ->type_name("PART")
        ->expected(1)
        ->take_all();
    options.bar = isatty(STDERR_FILENO) == 1;
}

void add_effects(CLI::App& app, EffectsOptions& options) {
    CLI::App* command = app.add_subcommand(
        "effects", "What every kernel and every effect costs, and how far each moves the balls");
    command->add_flag("--quick", options.plan.quick, "20 shots, not 200: some seconds");
    add_plan(command, options.plan);
    const auto count = [&options](std::int64_t) {
        options.counted = std::filesystem::read_symlink("/proc/self/exe").string();
    };
    command->add_flag_function(
        "--callgrind", count,
        "Counts instructions by valgrind: some minutes, good to the last one");
    command->add_option("--out", options.out, "Also writes DIR/effects.csv and DIR/effects.json")
        ->type_name("DIR");
    options.bar = isatty(STDERR_FILENO) == 1;
}

Status run(const CLI::App& app, const Options& options) {
    if (app.got_subcommand("accuracy"))
        return measure_accuracy(options.accuracy, std::cout, std::cerr);
    if (app.got_subcommand("effects"))
        return measure_effects(options.effects, std::cout, std::cerr);
    if (app.got_subcommand("bench")) return bench(options.csv, std::cout, std::cerr);
    if (app.got_subcommand("hash")) return print_hashes(std::cout);
    if (app.got_subcommand("compare"))
        return compare_solvers(options.compare, std::cout, std::cerr);
    return simulate_file(options.simulate, options.file, std::cout, std::cerr);
}

int run_program(int argc, char** argv) {
    Options options;
    CLI::App app(
        "Simulates scenes, and measures what that costs.\n"
        "Exit status: 0 fine, 1 an answer is wrong, 2 bad input, 130 interrupted.",
        "poolhall-lab");
    app.require_subcommand(1);
    add_simulate(app, options);
    add_compare(app, options.compare);
    add_accuracy(app, options.accuracy);
    add_effects(app, options.effects);
    CLI::App* bench =
        app.add_subcommand("bench", "Shots a second, ns an event, ns a ball-step, beside others");
    bench
        ->add_option("--csv", options.csv,
                     "Also write the table as CSV; - writes that to standard output, and no table")
        ->type_name("FILE");
    app.add_subcommand("hash", "The hash of each corpus of shots: the same on every machine");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : static_cast<int>(Status::kBadInput);
    }
    const Status status = run(app, options);
    if (std::cout.flush()) return static_cast<int>(status);
    if (status != Status::kBadInput)
        std::cerr << "poolhall-lab: standard output cannot be written\n";
    return static_cast<int>(Status::kBadInput);
}

}  // namespace

int main(int argc, char** argv) {
    std::ios::sync_with_stdio(false);
    // A reader that has gone shows as an error of the stream, which is said.
    std::signal(SIGPIPE, SIG_IGN);
    try {
        return run_program(argc, argv);
    } catch (const std::exception& error) {
        std::cerr << "poolhall-lab: " << error.what() << '\n';
        return static_cast<int>(Status::kBadInput);
    }
}
