#include "shared/game/resting.hpp"

#include "shared/game/end_game.hpp"
#include "shared/physics/check.hpp"
#include "tests/shared/random.hpp"

#include <gtest/gtest.h>
#include <string>

namespace poolhall {
namespace {

/// The end game's table with its two balls there.
Scene scene_at(Vec2 first, Vec2 second) {
    Scene scene = kEndGameRules.new_game(Seat{0}).scene;
    set_xy(scene.balls[0].state.r, first);
    set_xy(scene.balls[1].state.r, second);
    return scene;
}

TEST(PartOverlapping, ChangesNothingWhereBallsTouchAtMost) {
    const double radius = BallSpec{}.radius;
    Scene scene = scene_at({0.1, 0}, {0.1 + 2 * radius, 0});
    const Scene before = scene;
    part_overlapping(scene);
    EXPECT_EQ(before, scene);
}

TEST(PartOverlapping, MovesTheLaterBallStraightAway) {
    const double radius = BallSpec{}.radius;
    Scene scene = scene_at({0.1, 0.05}, {0.1 + radius, 0.05});
    part_overlapping(scene);
    EXPECT_EQ((Vec3{0.1, 0.05, 0}), scene.balls[0].state.r);
    EXPECT_NEAR(0.1 + 2 * radius, scene.balls[1].state.r.x, 1e-15);
    EXPECT_EQ(0.05, scene.balls[1].state.r.y);
}

TEST(PartOverlapping, FindsRoomAtRailsAndInCorners) {
    testing::Random random(5);
    const double radius = BallSpec{}.radius;
    const Vec2 edge = inset({end_game::kLength, end_game::kWidth}, radius);
    for (int i = 0; i < 2000; ++i) {
        const auto within = [&](double most) { return random.uniform(most - 3 * radius, most); };
        const Vec2 first{within(edge.x), within(edge.y)};
        const Vec2 second = i % 3 == 0 ? first : Vec2{within(edge.x), within(edge.y)};
        Scene scene = scene_at(first, second);
        part_overlapping(scene);
        const auto error = check(scene);
        ASSERT_FALSE(error) << error->pointer << " " << error->reason;
    }
}

TEST(PartOverlapping, LoosensARackThatIsPressedTogether) {
    testing::Random random(6);
    const double radius = BallSpec{}.radius;
    for (int i = 0; i < 200; ++i) {
        Scene scene = scene_at({-0.5, 0}, {0, 0});
        for (int ball = 0; ball < 9; ++ball) {
            const Vec2 place{1.73 * radius * (ball / 3),
                             2 * radius * (ball % 3 + 0.5 * (ball / 3))};
            const Vec2 r = place + 1e-3 * random.direction();
            scene.balls.push_back({std::to_string(ball), {{r.x, r.y, 0}, {}, {}}});
        }
        scene.balls.erase(scene.balls.begin() + 1);
        ASSERT_TRUE(check(scene));
        part_overlapping(scene);
        const auto error = check(scene);
        ASSERT_FALSE(error) << error->pointer << " " << error->reason;
    }
}

}  // namespace
}  // namespace poolhall
