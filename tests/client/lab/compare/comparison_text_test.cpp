#include "client/lab/compare/comparison_text.hpp"

#include "client/lab/input/scene_source.hpp"
#include "protocol/codec/scene_json.hpp"

#include <array>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

namespace poolhall::lab {
namespace {

constexpr std::array<SolverSpec, 3> kSolvers{
    {{SolverKind::kEvent}, {SolverKind::kEuler, 30}, {SolverKind::kOverlap, 30}}};

Scene scene_of_file(const std::string& name) {
    std::ifstream file(POOLHALL_SCENES "/" + name);
    SceneSource source(file);
    auto scene = protocol::scene_from_json(source.next().value().tree.value());
    return *scene;
}

/// All that is not a matter of time.
std::string text_of(const Scene& scene, const compare::Comparison& comparison) {
    std::ostringstream out;
    print_events(out, scene, comparison);
    print_differences(out << '\n', scene, comparison);
    print_rest_distances(out << '\n', scene, comparison);
    return out.str();
}

TEST(ComparisonText, IsTheGoldenOne) {
    const Scene scene = scene_of_file("draw.json");
    const std::string text = text_of(scene, compare::compare_solvers(scene, kSolvers));
    std::ifstream file(POOLHALL_GOLDEN);
    const std::string golden{std::istreambuf_iterator<char>(file), {}};
    EXPECT_EQ(text, golden);
}

TEST(ComparisonText, ARefusalStandsInItsColumnAndTheOthersGoOn) {
    const Scene scene = scene_of_file("jump.json");
    const std::string text = text_of(scene, compare::compare_solvers(scene, kSolvers));
    const std::string reason = "refused: /solver/kind: overlap knows no heights: not with airborne";
    const std::size_t column = text.find(reason);
    ASSERT_NE(column, std::string::npos);
    EXPECT_NE(text.find(reason, column + 1), std::string::npos) << "not among the differences";
    EXPECT_NE(text.find("cue hits object"), std::string::npos);
}

}  // namespace
}  // namespace poolhall::lab
