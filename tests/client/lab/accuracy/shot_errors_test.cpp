#include "client/lab/accuracy/shot_errors.hpp"

#include "client/lab/corpora/scene_makers.hpp"
#include "client/lab/ensembles/ensembles.hpp"
#include "shared/physics/simulate.hpp"

#include <gtest/gtest.h>

namespace poolhall::lab {
namespace {

/// A ball that rolls 2 m/s^2 slower every second, and hits another head-on.
Scene head_on(const SolverSpec& solver) {
    Scene scene = scene_of({{-0.5, 0}, {0.25 + 2 * BallSpec{}.radius, 0}});
    set_xy(scene.balls[0].state.v, {2, 0});
    scene.effects.rolling = RollingSpec{0.25};
    scene.gravity = 8;
    scene.solver = solver;
    return scene;
}

TEST(ShotErrors, OfAShotAgainstItselfAreNothing) {
    for (const char* name : {"two_balls", "nine_ball_break"}) {
        const Scene scene = scenes_of(*find_ensemble(name), 1, 1)[0];
        const ShotTrace trace = simulate(scene);
        const ShotErrors errors = errors_of(scene, trace, trace);
        EXPECT_EQ(errors.rest, 0);
        EXPECT_EQ(errors.impact->time, 0);
        EXPECT_EQ(errors.impact->place, 0);
        EXPECT_EQ(errors.impact->velocity, 0);
        EXPECT_EQ(errors.energy_drift, 0);
        EXPECT_EQ(errors.matching_events, static_cast<double>(trace.events.size()));
        EXPECT_EQ(errors.horizon, trace.duration);
        EXPECT_FALSE(errors.verdict_flips);
        EXPECT_EQ(errors.missed + errors.invented, 0);
    }
}

TEST(ShotErrors, AreThoseOfAnEulerStepByHand) {
    // True: 0.75 m at 2 m/s less 2 m/s^2 take 0.5 s, and 1 m/s is left: 0.25 m of way.
    const Scene scene = head_on({SolverKind::kEvent});
    const ShotTrace truth = simulate(scene);
    ASSERT_NEAR(truth.events[0].t, 0.5, 1e-15);
    // Ticks of 1/4 s: 0.5 m with 2 m/s, the other 0.25 m with 1.5 m/s by 0.25 + 1/6 s. The object
    // ball has 1.5 m/s then: 1/12 s of it, then ticks with 1, 0.5 and 0 m/s.
    const ShotTrace euler = simulate(head_on({SolverKind::kEuler, 4}));
    const ShotErrors errors = errors_of(scene, truth, euler);
    ASSERT_TRUE(errors.impact);
    EXPECT_NEAR(errors.impact->time, 0.5 - (0.25 + 1.0 / 6), 1e-15);
    EXPECT_NEAR(errors.impact->place, 0, 1e-15);
    EXPECT_NEAR(errors.impact->velocity, 0.5, 1e-15);
    EXPECT_NEAR(errors.rest, 1.5 / 12 + 0.25 + 0.125 - 0.25, 1e-15);
    // After the impact (1.5^2 - 1^2) / 2, of 2^2 / 2 at the beginning.
    EXPECT_NEAR(errors.energy_drift, (1.5 * 1.5 - 1) / 4, 1e-15);
    EXPECT_EQ(errors.matching_events, static_cast<double>(truth.events.size()));
}

TEST(ShotErrors, NoImpactErrorsWhereTheFirstImpactIsAnother) {
    const Scene scene = head_on({SolverKind::kEvent});
    const ShotTrace truth = simulate(scene);
    ShotTrace other = truth;
    other.events.erase(other.events.begin());
    const ShotErrors errors = errors_of(scene, truth, other);
    EXPECT_FALSE(errors.impact);
    EXPECT_EQ(errors.matching_events, 0);
    EXPECT_EQ(errors.missed, 1);
}

}  // namespace
}  // namespace poolhall::lab
