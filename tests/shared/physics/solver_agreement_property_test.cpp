// What the event solver finds is what the ticks of exact_arc come to as they grow shorter. Where a
// solver has a rule of its own for some rare contact, the difference stays.

#include "shared/analysis/agreement.hpp"
#include "tests/shared/random.hpp"
#include "tests/shared/scenes.hpp"
#include "tests/shared/solvers.hpp"

#include <gtest/gtest.h>
#include <string>

namespace poolhall {
namespace {

struct Kind {
    const char* name;
    void (*change)(Scene& scene, testing::Random& random);
};

void into_mouths(Scene& scene, testing::Random& /*random*/) {
    scene.table.pockets = PocketModel::kPool;
}

void into_circles(Scene& scene, testing::Random& random) {
    scene.table.pockets = PocketModel::kCircles;
    for (const char* id : {"a", "b", "c", "d"}) {
        const Vec2 centre{random.uniform(-1.2, 1.2), random.uniform(-0.6, 0.6)};
        scene.table.circles.push_back({id, centre, random.uniform(0.03, 0.15)});
    }
}

void jump(Scene& scene, testing::Random& random) {
    scene.effects.airborne = AirborneSpec{random.uniform(0, 0.8)};
    scene.strike->elevation = random.uniform(0.1, 1.5);
}

void jump_into_mouths(Scene& scene, testing::Random& random) {
    into_mouths(scene, random);
    jump(scene, random);
}

void jump_into_circles(Scene& scene, testing::Random& random) {
    into_circles(scene, random);
    jump(scene, random);
}

void unequal_balls(Scene& scene, testing::Random& random) {
    for (SceneBall& ball : scene.balls) {
        ball.radius = random.uniform(0.015, 0.035);
        ball.mass = random.uniform(0.05, 0.4);
    }
}

class SolversAgree : public ::testing::TestWithParam<Kind> {};

INSTANTIATE_TEST_SUITE_P(Kinds, SolversAgree,
                         ::testing::Values(Kind{"mouths", into_mouths},
                                           Kind{"circles", into_circles},
                                           Kind{"jumps_into_mouths", jump_into_mouths},
                                           Kind{"jumps_into_circles", jump_into_circles},
                                           Kind{"unequal_balls", unequal_balls}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(SolversAgree, OnRandomShotsOfAFewBalls) {
    testing::Random random(11);
    for (int i = 0; i < 300; ++i) {
        Scene scene = testing::random_scene(random, 1 + random.below(3), random.uniform(0.5, 6));
        scene.effects = testing::pool_effects();
        scene.strike->offset = 0.5 * random.direction();
        GetParam().change(scene, random);
        scene.solver = {SolverKind::kEvent};
        if (check(scene)) continue;  // a ball beside a mouth
        const ShotTrace by_events = simulate(scene);
        bool same_verdict = false;
        double apart = 0;
        for (const double hz : {1920.0, 7680.0, 30720.0}) {
            scene.solver = {SolverKind::kExactArc, hz};
            const ShotTrace by_ticks = simulate(scene);
            same_verdict = analysis::is_same_verdict(by_events, by_ticks);
            apart = analysis::farthest_at_rest(by_events, by_ticks);
            if (same_verdict && apart < 1e-4) break;
        }
        EXPECT_TRUE(same_verdict) << "shot " << i;
        EXPECT_LT(apart, 1e-3) << "shot " << i;
    }
}

}  // namespace
}  // namespace poolhall
