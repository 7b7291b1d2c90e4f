// The reference in 113 bits against numbers that were computed in another way, to 1e-30 and better.

#include "client/lab/corpora/scene_makers.hpp"
#include "tests/client/lab/reference/exact_shot.hpp"
#include "tests/shared/quad_shots.hpp"

#include <gtest/gtest.h>

namespace poolhall::lab {
namespace {

using poolhall::testing::ReferenceCase;

constexpr double kRadius = BallSpec{}.radius;
/// Relative, or in m and s where those are of size 1.
constexpr double kTolerance = 1e-30;

Scene on_endless_cloth(Scene scene) {
    scene.table.rails = false;
    scene.effects.ball_ball.min_separation = 0;
    return scene;
}

// --- one ball ------------------------------------------------------------------------------------

Scene sliding_scene(const ReferenceCase& one) {
    Scene scene = on_endless_cloth(scene_of(Vec2{}, {one.input("v0", 0), one.input("v0", 1)}));
    scene.balls[0].state.w = {one.input("w0", 0), one.input("w0", 1), 0};
    scene.ball.radius = one.input("R");
    scene.gravity = one.input("g");
    scene.effects.sliding = SlidingSpec{one.input("mu_s")};
    scene.effects.rolling = RollingSpec{one.input("mu_r")};
    return scene;
}

TEST(ReferenceClosedForm, BallSlidesRollsAndRests) {
    for (const auto& one : poolhall::testing::reference_cases("a_slide_roll_rest")) {
        SCOPED_TRACE(one.id);
        const ExactShot shot(sliding_scene(one));
        const auto slide = shot.events(EventKind::kSlideToRoll);
        const auto rest = shot.events(EventKind::kRollToRest);
        ASSERT_EQ(1U, slide.size());
        ASSERT_EQ(1U, rest.size());
        EXPECT_LE(abs(shot.t(slide[0]) - exact(one.expect.at("t_slide"))), kTolerance);
        EXPECT_LE(distance(shot.place_after(slide[0]), exact_vector(one.expect.at("pos_roll"))),
                  kTolerance);
        EXPECT_LE(error_of(shot.t(rest[0]), exact(one.expect.at("t_rest"))), kTolerance);
        EXPECT_LE(distance(shot.final_place(0), exact_vector(one.expect.at("pos_rest"))),
                  kTolerance);
    }
}

TEST(ReferenceClosedForm, BallUnderLinearDragStopsAtItsStopSpeed) {
    Scene scene = on_endless_cloth(scene_of(Vec2{0.125, -0.25}, {3, 4}));
    scene.effects.linear_drag = LinearDragSpec{0.6, 0.0625};
    const ExactShot shot(scene);
    const Exact k = 0.6;
    ASSERT_EQ(1U, shot.trace().events.size());
    EXPECT_LE(error_of(shot.t(0), log(Exact(80)) / k), kTolerance);
    // It has gone v/k (1 - 1/80) of the way that would take for ever.
    const Exact share = Exact(79) / 80 / k;
    EXPECT_LE(distance(shot.final_place(0), {0.125 + 3 * share, -0.25 + 4 * share}), kTolerance);
}

// --- two balls -----------------------------------------------------------------------------------

TEST(ReferenceClosedForm, RollingBallMeetsAnotherOffCentre) {
    int hits = 0;
    for (const auto& one : poolhall::testing::reference_cases("b_toi_decel")) {
        if (one.inputs.at("b").is_string()) continue;  // no double
        SCOPED_TRACE(one.id);
        Scene scene = on_endless_cloth(scene_of({{0, 0}, {one.input("D"), one.input("b")}}));
        scene.balls[0].state.v.x = one.input("v0");
        // Without friction that acts on slip a ball rolls whatever its spin, which a double could
        // not give exactly.
        scene.effects.rolling = RollingSpec{one.input("mu_r")};
        const ExactShot shot(scene);
        const auto met = shot.events(EventKind::kBallBall);
        ASSERT_EQ(one.expect.at("hit").get<bool>() ? 1U : 0U, met.size());
        if (met.empty()) continue;
        ++hits;
        EXPECT_LE(error_of(shot.t(met[0]), exact(one.expect.at("t"))), kTolerance);
        const double speed = one.input("v0");
        EXPECT_LE(distance(shot.velocity_after(met[0], 0), exact_vector(one.expect.at("v_cue"))),
                  kTolerance * speed);
        EXPECT_LE(distance(shot.velocity_after(met[0], 1), exact_vector(one.expect.at("v_obj"))),
                  kTolerance * speed);
    }
    EXPECT_GE(hits, 10);
}

TEST(ReferenceClosedForm, BallsThatMeetHeadOnPartAsTheirRestitutionSays) {
    for (const double e : {1.0, 0.95, 0.0}) {
        SCOPED_TRACE(e);
        Scene scene = on_endless_cloth(scene_of({{0, 0}, {0.75, 0}}));
        scene.balls[0].state.v.x = 1.7;
        scene.effects.ball_ball.model = BallBallModel::kRestitution;
        scene.effects.ball_ball.e = e;
        scene.limits.time = 1;
        const ExactShot shot(scene);
        ASSERT_EQ(1U, shot.trace().events.size());
        EXPECT_LE(error_of(shot.t(0), (Exact(0.75) - 2 * Exact(kRadius)) / Exact(1.7)), kTolerance);
        EXPECT_LE(error_of(shot.velocity_after(0, 0).x, (1 - Exact(e)) / 2 * Exact(1.7)),
                  kTolerance);
        EXPECT_LE(error_of(shot.velocity_after(0, 1).x, (1 + Exact(e)) / 2 * Exact(1.7)),
                  kTolerance);
    }
}

// --- rails ---------------------------------------------------------------------------------------

/// x folded between elastic rails at +-edge.
Exact folded(const Exact& x, const Exact& edge) {
    const Exact period = 4 * edge;
    Exact rest = x + edge - period * floor((x + edge) / period);
    if (rest > 2 * edge) rest = period - rest;
    return rest - edge;
}

/// A ball that runs without friction for so long from elastic rail to rail ends where the line
/// that it would run on without rails is folded to.
void expect_unfolded(double time, std::size_t least_rails) {
    const Vec2 r{0.3, -0.17};
    const Vec2 v{1.7, 0.9};
    Scene scene = scene_of(r, v);
    scene.limits.time = time;
    const ExactShot shot(scene);
    EXPECT_GE(shot.events(EventKind::kBallRail).size(), least_rails);
    const Vec2 edge = inset(scene.table, kRadius);
    const ExactVec expected{folded(r.x + Exact(v.x) * time, edge.x),
                            folded(r.y + Exact(v.y) * time, edge.y)};
    EXPECT_LE(distance(shot.final_place(0), expected), kTolerance);
}

TEST(ReferenceClosedForm, ChainOfTenRailsUnfolds) {
    expect_unfolded(8, 10);
}

TEST(ReferenceClosedForm, ChainOfAThousandRailsUnfolds) {
    expect_unfolded(720, 1000);
}

// --- whole shots ---------------------------------------------------------------------------------

TEST(ReferenceClosedForm, RacksEndWhereAnotherProgramIn113BitsEndsThem) {
    const nlohmann::json file = poolhall::testing::reference_file("quad_shots.json");
    for (const nlohmann::json& one : file.at("shots")) {
        SCOPED_TRACE(one.at("id").get<std::string>());
        const Scene scene = poolhall::testing::quad_scene(file.at("model"), one);
        const ExactShot shot(scene, RailPlaces::kExact);
        for (std::size_t i = 0; i < scene.balls.size(); ++i) {
            const ExactVec place = shot.final_place(i);
            const ExactVec from_corner{place.x + scene.table.length / 2,
                                       place.y + scene.table.width / 2};
            // All of the file's 22 digits.
            EXPECT_LE(distance(from_corner, exact_vector(one.at("balls")[i].at("rest"))), 2e-21);
        }
    }
}

}  // namespace
}  // namespace poolhall::lab
