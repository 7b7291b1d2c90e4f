#include "tests/shared/scenes.hpp"
#include "tests/shared/traces.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace poolhall {
namespace {

using testing::events_of;

/// One ball shot through others at rest on an endless cloth, up to 30 m/s.
Scene shot_through(testing::Random& random, double hz) {
    Scene scene = testing::random_scene(random, 12, random.uniform(0.5, 30));
    scene.table.rails = false;
    scene.effects.linear_drag.reset();
    scene.limits.time = 3 / scene.strike->speed;
    scene.solver.hz = hz;
    return scene;
}

TEST(Tunnelling, FirstHitAt30HertzIsTheClosedForms) {
    testing::Random random(41);
    int hits = 0;
    for (int i = 0; i < 3000; ++i) {
        const Scene scene = shot_through(random, 30);
        const Vec2 start = xy(scene.balls[0].state.r);
        const Vec2 v = scene.strike->speed * normalized(scene.strike->direction);
        // At rest the others make a list of closed forms of which the least is first.
        double first = scene.limits.time;
        for (std::size_t ball = 1; ball < scene.balls.size(); ++ball) {
            const Vec2 c = xy(scene.balls[ball].state.r) - start;
            const double along = dot(c, v) / norm(v);
            const double aside = cross(c, v) / norm(v);
            const double depth = 4 * scene.ball.radius * scene.ball.radius - aside * aside;
            if (along <= 0 || depth < 0) continue;
            first = std::min(first, (along - std::sqrt(depth)) / norm(v));
        }
        const auto found = events_of(simulate(scene), EventKind::kBallBall);
        if (first >= scene.limits.time) {
            EXPECT_TRUE(found.empty());
            continue;
        }
        ++hits;
        ASSERT_FALSE(found.empty()) << i;
        EXPECT_NEAR(first, found[0].t, 1e-9);
    }
    EXPECT_GT(hits, 500);
}

TEST(Tunnelling, HitsAt30HertzAreThoseAt7680) {
    for (int i = 0; i < 200; ++i) {
        testing::Random coarse_random(static_cast<std::uint64_t>(i));
        testing::Random fine_random(static_cast<std::uint64_t>(i));
        const auto coarse =
            events_of(simulate(shot_through(coarse_random, 30)), EventKind::kBallBall);
        const auto fine =
            events_of(simulate(shot_through(fine_random, 7680)), EventKind::kBallBall);
        // Two balls that are hit one after the other can part the runs by rounding, many times
        // magnified; the first few hits cannot.
        ASSERT_EQ(coarse.empty(), fine.empty()) << i;
        for (std::size_t k = 0; k < std::min({coarse.size(), fine.size(), std::size_t{3}}); ++k) {
            EXPECT_EQ(fine[k].balls, coarse[k].balls) << i;
            EXPECT_NEAR(fine[k].t, coarse[k].t, 1e-8) << i;
        }
    }
}

}  // namespace
}  // namespace poolhall
