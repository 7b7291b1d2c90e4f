#include "client/lab/simulate/simulate_command.hpp"

#include "client/lab/input/scene_source.hpp"
#include "protocol/codec/scene_json.hpp"
#include "protocol/wire/scene_fields.hpp"
#include "shared/physics/simulate.hpp"

#include <chrono>
#include <iostream>
#include <new>
#include <utility>

namespace poolhall::lab {

namespace {

using Json = nlohmann::ordered_json;

/// As many places of balls as samples may hold: 240 MB.
constexpr double kMaxSampledPlaces = 1e7;

/// Simulates scene after scene in the same memory.
class SceneRunner {
  public:
    SceneRunner(const SimulateOptions& options, std::ostream& out) : options_(options), out_(out) {}

    /// Writes the result of one scene; what is wrong with it otherwise.
    std::optional<SceneError> run(Json tree) {
        if (options_.solver && tree.is_object())
            tree["solver"] = protocol::wire::Object<SolverSpec>{}.write(*options_.solver,
                                                                        protocol::Encoding::kJson);
        const auto scene = protocol::scene_from_json(tree);
        if (!scene) return scene.error();
        const std::uint64_t ns = simulate(*scene);
        if (options_.sample_hz > 0) {
            const double places = (trace_.duration * options_.sample_hz + 2) *
                                  static_cast<double>(scene->balls.size());
            if (places > kMaxSampledPlaces)
                return SceneError{"", "needs more than 10 million samples of a ball"};
            simulator_.simulate(*scene, options_.sample_hz, trace_);
        }
        protocol::write_result(out_, trace_, *scene, {options_.numbers, ns});
        out_ << '\n' << std::flush;
        return std::nullopt;
    }

  private:
    /// What it took, ns. Without samples, which are no part of the cost.
    std::uint64_t simulate(const Scene& scene) {
        using Clock = std::chrono::steady_clock;
        const auto start = Clock::now();
        simulator_.simulate(scene, 0, trace_);
        const std::chrono::nanoseconds passed = Clock::now() - start;
        return static_cast<std::uint64_t>(passed.count());
    }

    const SimulateOptions& options_;
    std::ostream& out_;
    Simulator simulator_;
    ShotTrace trace_;
};

/// The same, where the scene's events or samples may be more than memory holds.
std::optional<SceneError> run_safely(SceneRunner& runner, Json tree) {
    try {
        return runner.run(std::move(tree));
    } catch (const std::bad_alloc&) {
        return SceneError{"/limits", "allow more than fits into memory"};
    }
}

}  // namespace

Status simulate_all(const SimulateOptions& options, std::istream& in, std::ostream& out,
                    std::ostream& error) {
    SceneSource source(in);
    SceneRunner runner(options, out);
    Status status = Status::kGood;
    while (auto text = source.next()) {
        std::string fault;
        if (!text->tree) {
            fault = text->tree.error();
        } else if (const auto wrong = run_safely(runner, std::move(*text->tree))) {
            fault = text_of(*wrong);
        }
        if (!out) return fail(error, "standard output cannot be written");
        if (fault.empty()) continue;
        error << "line " << text->line << ": " << fault << std::endl;
        status = Status::kBadInput;
    }
    if (in.bad()) return fail(error, "the input cannot be read to its end");
    return status;
}

Status simulate_file(const SimulateOptions& options, const std::string& file, std::ostream& out,
                     std::ostream& error) {
    if (file == "-") return simulate_all(options, std::cin, out, error);
    auto in = open_scenes(file);
    if (!in) return fail(error, in.error());
    return simulate_all(options, *in, out, error);
}

}  // namespace poolhall::lab
