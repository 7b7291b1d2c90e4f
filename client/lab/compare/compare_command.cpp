#include "client/lab/compare/compare_command.hpp"

#include "client/compare/comparison.hpp"
#include "client/files/output_file.hpp"
#include "client/lab/compare/comparison_text.hpp"
#include "client/lab/compare/picture.hpp"
#include "client/lab/input/scene_source.hpp"
#include "protocol/codec/scene_json.hpp"
#include "protocol/wire/scene_fields.hpp"

#include <filesystem>
#include <iostream>
#include <memory>
#include <new>
#include <system_error>

namespace poolhall::lab {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using compare::Comparison;

std::vector<SolverSpec> solvers_of(const CompareOptions& options) {
    if (!options.solvers.empty()) return options.solvers;
    return {{SolverKind::kEvent},
            {SolverKind::kEuler, 30},
            {SolverKind::kEuler, 120},
            {SolverKind::kOverlap, 30}};
}

/// A picture that will be written, its file open already.
struct Target {
    PictureFormat format;
    std::unique_ptr<files::OutputFile> file;
};

Result<std::vector<Target>, std::string> open_targets(const CompareOptions& options) {
    std::vector<std::pair<fs::path, PictureFormat>> wanted;
    if (!options.picture.empty()) {
        const fs::path path = options.picture;
        if (path.extension() != ".svg" && path.extension() != ".png")
            return options.picture + " must end in .svg or .png";
        wanted.emplace_back(path,
                            path.extension() == ".svg" ? PictureFormat::kSvg : PictureFormat::kPng);
    }
    if (!options.out.empty()) {
        std::error_code failed;
        fs::create_directories(options.out, failed);
        if (failed) return options.out + " is no folder, and cannot be made one";
        wanted.emplace_back(fs::path(options.out) / "compare.svg", PictureFormat::kSvg);
        wanted.emplace_back(fs::path(options.out) / "compare.png", PictureFormat::kPng);
    }
    std::vector<Target> targets;
    for (const auto& [path, format] : wanted) {
        targets.push_back({format, std::make_unique<files::OutputFile>(path)});
        if (const auto& fault = targets.back().file->fault()) return *fault;
    }
    return targets;
}

/// The scene with the first of the solvers that takes it, or why none does.
Result<Scene, SceneError> scene_for(Json tree, const std::vector<SolverSpec>& solvers) {
    SceneError first_reason;
    for (const SolverSpec& solver : solvers) {
        if (tree.is_object())
            tree["solver"] =
                protocol::wire::Object<SolverSpec>{}.write(solver, protocol::Encoding::kJson);
        auto scene = protocol::scene_from_json(tree);
        if (scene) return scene;
        if (first_reason.reason.empty()) first_reason = scene.error();
    }
    return first_reason;
}

/// The one scene of the input, or why there is none, with its line.
Result<Scene, std::string> read_scene(std::istream& in, const std::vector<SolverSpec>& solvers) {
    SceneSource source(in);
    auto text = source.next();
    if (in.bad()) return std::string("the input cannot be read to its end");
    if (!text) return std::string("there is no scene");
    const std::string where = "line " + std::to_string(text->line) + ": ";
    if (!text->tree) return where + text->tree.error();
    auto scene = scene_for(std::move(*text->tree), solvers);
    if (!scene) return where + text_of(scene.error());
    if (const auto more = source.next())
        return "line " + std::to_string(more->line) + ": there is more than one scene";
    return *std::move(scene);
}

Result<Scene, std::string> scene_of(const CompareOptions& options,
                                    const std::vector<SolverSpec>& solvers) {
    if (options.file == "-") return read_scene(std::cin, solvers);
    auto in = open_scenes(options.file);
    if (!in) return in.error();
    return read_scene(*in, solvers);
}

void print(std::ostream& out, const Scene& scene, const Comparison& comparison) {
    print_events(out, scene, comparison);
    print_differences(out << '\n', scene, comparison);
    print_rest_distances(out << '\n', scene, comparison);
    print_costs(out << '\n', comparison);
}

Status compare_scene(const Scene& scene, const std::vector<SolverSpec>& solvers,
                     std::vector<Target>& targets, std::ostream& out, std::ostream& error) {
    const Comparison comparison = compare::compare_solvers(scene, solvers);
    print(out, scene, comparison);
    if (!targets.empty()) out << '\n';
    for (Target& target : targets) {
        const auto picture = picture_of(scene, comparison, target.format);
        const std::string path = target.file->path().string();
        if (!picture) return fail(error, path + ": " + picture.error().reason);
        target.file->stream() << *picture;
        target.file->finish();
        if (const auto& fault = target.file->fault()) return fail(error, *fault);
        out << "Drawn: " << path << '\n';
    }
    return Status::kGood;
}

}  // namespace

Status compare_solvers(const CompareOptions& options, std::ostream& out, std::ostream& error) {
    const auto solvers = solvers_of(options);
    const auto scene = scene_of(options, solvers);
    if (!scene) return fail(error, scene.error());
    auto targets = open_targets(options);
    if (!targets) return fail(error, targets.error());
    try {
        return compare_scene(*scene, solvers, *targets, out, error);
    } catch (const std::bad_alloc&) {
        return fail(error, "/limits: allow more than fits into memory");
    }
}

}  // namespace poolhall::lab
