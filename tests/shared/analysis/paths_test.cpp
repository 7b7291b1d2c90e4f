#include "shared/analysis/paths.hpp"

#include "client/lab/corpora/scene_makers.hpp"
#include "shared/physics/simulate.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace poolhall::analysis {
namespace {

/// One ball that bounces off the E rail and then rolls out.
Scene bounce() {
    Scene scene = lab::scene_of({1, 0}, {1, 0.3});
    scene.effects.rolling = RollingSpec{};
    scene.solver = {SolverKind::kEvent};
    return scene;
}

TEST(Paths, BeginWithTheSceneAndEndAtRest) {
    const Scene scene = bounce();
    const ShotTrace trace = simulate(scene, 30);
    const Path path = paths_of(scene, trace).at(0);
    EXPECT_EQ(path.front().r, (Vec2{1, 0}));
    EXPECT_EQ(path.back().r, xy(trace.balls[0].state.r));
    EXPECT_EQ(path.back().t, trace.duration);
    for (std::size_t i = 1; i < path.size(); ++i)
        EXPECT_LE(path[i - 1].t, path[i].t);
}

TEST(Paths, HaveACornerAtTheExactPlaceOfABounce) {
    const Scene scene = bounce();
    const ShotTrace trace = simulate(scene, 30);
    const std::vector<Vec2> outline = outline_of(paths_of(scene, trace).at(0), 1e-6);
    const std::vector<Vec2> impacts = impacts_of(trace);
    ASSERT_EQ(impacts.size(), 4U);
    EXPECT_DOUBLE_EQ(impacts[0].x, inset(scene.table, scene.ball.radius).x);
    ASSERT_EQ(outline.size(), impacts.size() + 2);  // straight in between
    for (std::size_t i = 0; i < impacts.size(); ++i)
        EXPECT_EQ(outline[i + 1], impacts[i]);
}

TEST(Paths, WithoutSamplesGoFromEventToEvent) {
    const Scene scene = bounce();
    const Path path = paths_of(scene, simulate(scene)).at(0);
    EXPECT_EQ(path.size(), 7U);  // the start, four rails, the rest as an event and as the end
}

TEST(PlaceAt, IsBetweenThePointsAndHeldOutside) {
    const Path path{{0, {0, 0}}, {1, {2, 0}}, {1, {2, 0}}, {3, {2, 4}}};
    EXPECT_EQ(place_at(path, -1), (Vec2{0, 0}));
    EXPECT_EQ(place_at(path, 0.25), (Vec2{0.5, 0}));
    EXPECT_EQ(place_at(path, 1), (Vec2{2, 0}));
    EXPECT_EQ(place_at(path, 2), (Vec2{2, 2}));
    EXPECT_EQ(place_at(path, 9), (Vec2{2, 4}));
}

TEST(Outline, StaysWithinItsTolerance) {
    Path circle;
    constexpr int kPoints = 1000;
    for (int i = 0; i <= kPoints; ++i) {
        const double angle = 6.0 * i / kPoints;
        circle.push_back({angle, {std::cos(angle), std::sin(angle)}});
    }
    const std::vector<Vec2> outline = outline_of(circle, 1e-3);
    EXPECT_LT(outline.size(), 150U);
    for (std::size_t i = 1; i < outline.size(); ++i)
        EXPECT_GT(norm(0.5 * (outline[i - 1] + outline[i])), 1 - 1.1e-3);
}

TEST(Outline, OfABallThatStandsIsAPoint) {
    EXPECT_TRUE(outline_of({}, 1e-3).empty());
    EXPECT_EQ(outline_of({{0, {1, 2}}}, 1e-3).size(), 1U);
    const std::vector<Vec2> outline = outline_of({{0, {1, 2}}, {1, {1, 2}}, {2, {1, 2}}}, 1e-3);
    ASSERT_EQ(outline.size(), 2U);
    EXPECT_EQ(outline[0], outline[1]);
}

}  // namespace
}  // namespace poolhall::analysis
