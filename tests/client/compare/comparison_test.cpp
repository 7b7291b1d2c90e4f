#include "client/compare/comparison.hpp"

#include "client/compare/number_text.hpp"
#include "client/lab/corpora/scene_makers.hpp"
#include "shared/physics/simulate.hpp"

#include <array>
#include <gtest/gtest.h>

namespace poolhall::compare {
namespace {

constexpr SolverSpec kEvent{SolverKind::kEvent};
constexpr SolverSpec kEuler30{SolverKind::kEuler, 30};
constexpr SolverSpec kEuler480{SolverKind::kEuler, 480};

/// A cue ball that cuts an object ball on real cloth.
Scene cut() {
    Scene scene = lab::scene_of({{-0.5, 0}, {0.5, 0.02}});
    scene.effects = lab::cloth_effects();
    scene.strike = Strike{BallIndex{0}, {1, 0}, 3};
    return scene;
}

TEST(Comparison, GivesEachSolversOwnShot) {
    const std::array solvers{kEuler30, kEvent};
    const Comparison comparison = compare::compare_solvers(cut(), solvers);
    ASSERT_EQ(comparison.runs.size(), 2U);
    for (const SolverRun& run : comparison.runs) {
        Scene scene = cut();
        scene.solver = run.solver;
        EXPECT_EQ(run.trace.hash, simulate(scene).hash);
        EXPECT_GT(run.trace.sample_count(), 100U);
        EXPECT_GT(run.cpu_ns, 0);
    }
}

TEST(Comparison, MeasuresFromTheEventSolverWhereverItStands) {
    const std::array solvers{kEuler30, kEuler480, kEvent};
    const Comparison comparison = compare::compare_solvers(cut(), solvers);
    EXPECT_EQ(comparison.reference, 2U);
    EXPECT_EQ(comparison.runs[2].rest_distance, (std::vector<double>{0, 0}));
    const auto coarse = farthest_ball(comparison.runs[0]);
    const auto fine = farthest_ball(comparison.runs[1]);
    ASSERT_TRUE(coarse && fine);
    EXPECT_GT(coarse->distance, fine->distance);
    EXPECT_GT(fine->distance, 0);
}

TEST(Comparison, TheHighestRateIsTheReferenceWhereTheEventSolverRefuses) {
    Scene scene = cut();
    scene.effects.linear_drag = LinearDragSpec{};  // no closed form together with the cloth
    const std::array solvers{kEvent, kEuler30, kEuler480};
    const Comparison comparison = compare::compare_solvers(scene, solvers);
    EXPECT_EQ(comparison.reference, 2U);
    ASSERT_TRUE(comparison.runs[0].refusal);
    EXPECT_EQ(comparison.runs[0].refusal->pointer, "/solver/kind");
    EXPECT_FALSE(farthest_ball(comparison.runs[0]));
    EXPECT_TRUE(farthest_ball(comparison.runs[1]));
}

TEST(Comparison, NoReferenceWhereAllRefuse) {
    Scene scene = cut();
    scene.effects.linear_drag = LinearDragSpec{};
    const Comparison comparison = compare::compare_solvers(scene, std::array{kEvent});
    EXPECT_FALSE(comparison.reference);
}

TEST(Comparison, SamplesOfAnEndlessShotStayWithinMemory) {
    Scene scene = lab::scene_of({0, 0}, {1, 0.7});
    scene.limits.time = 1e5;
    const Comparison comparison =
        compare::compare_solvers(scene, std::array{kEvent}, {.repeats = 1});
    const ShotTrace& trace = comparison.runs[0].trace;
    EXPECT_EQ(trace.outcome, Outcome::kTimeLimit);
    EXPECT_LE(static_cast<double>(trace.sample_count()), kMaxPlaces + 2);
    EXPECT_GT(static_cast<double>(trace.sample_count()), kMaxPlaces / 2);
}

TEST(Label, IsWhatTheLabsOptionsTake) {
    EXPECT_EQ(label(kEvent), "event");
    EXPECT_EQ(label(kEuler30), "euler:30");
    EXPECT_EQ(label({SolverKind::kExactArc, 7680}), "exact_arc:7680");
}

TEST(Label, NumbersHaveTheirUnits) {
    EXPECT_EQ(text_of_cost(12345), "12.3 \xC2\xB5s");
    EXPECT_EQ(text_of_cost(12345678), "12346 \xC2\xB5s");
    EXPECT_EQ(text_of_distance(0.0123456), "12.35 mm");
    EXPECT_EQ(text_of_distance(1e-9), "1e-06 mm");
}

}  // namespace
}  // namespace poolhall::compare
