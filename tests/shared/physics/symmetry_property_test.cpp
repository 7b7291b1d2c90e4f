#include "tests/shared/pressed_scenes.hpp"
#include "tests/shared/random.hpp"
#include "tests/shared/scenes.hpp"
#include "tests/shared/solvers.hpp"
#include "tests/shared/traces.hpp"

#include <bit>
#include <gtest/gtest.h>

namespace poolhall {
namespace {

/// A change of a scene that must change nothing in what happens but itself.
struct Symmetry {
    const char* name;
    Vec2 sign;      ///< of x and y
    bool renumber;  ///< the last ball first
};

void PrintTo(const Symmetry& symmetry, std::ostream* out) {
    *out << symmetry.name;
}

/// The first ball becomes the last and so on.
std::size_t renumbered(const Symmetry& symmetry, std::size_t ball, std::size_t count) {
    return symmetry.renumber ? count - 1 - ball : ball;
}

Vec3 mirrored(const Symmetry& symmetry, const Vec3& a) {
    return {symmetry.sign.x * a.x, symmetry.sign.y * a.y, a.z};
}

/// A mirror turns spin and side round once more than a direction.
Vec3 mirrored_spin(const Symmetry& symmetry, const Vec3& w) {
    const double hand = symmetry.sign.x * symmetry.sign.y;
    return {hand * symmetry.sign.x * w.x, hand * symmetry.sign.y * w.y, hand * w.z};
}

Scene image_of(const Scene& scene, const Symmetry& symmetry) {
    Scene image = scene;
    const std::size_t count = scene.balls.size();
    for (std::size_t i = 0; i < count; ++i) {
        SceneBall& ball = image.balls[renumbered(symmetry, i, count)];
        ball = scene.balls[i];
        ball.state.r = mirrored(symmetry, ball.state.r);
        ball.state.v = mirrored(symmetry, ball.state.v);
        ball.state.w = mirrored_spin(symmetry, ball.state.w);
    }
    if (image.strike) {
        const std::size_t struck = renumbered(symmetry, scene.strike->ball.value, count);
        image.strike->ball.value = static_cast<std::uint16_t>(struck);
        image.strike->direction.x *= symmetry.sign.x;
        image.strike->direction.y *= symmetry.sign.y;
        image.strike->offset.x *= symmetry.sign.x * symmetry.sign.y;
    }
    return image;
}

/// Equal to the bit, 0 and -0 taken as one.
bool same(const Vec3& a, const Vec3& b) {
    const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x + 0.0); };
    return bits(a.x) == bits(b.x) && bits(a.y) == bits(b.y) && bits(a.z) == bits(b.z);
}

void expect_image(const Scene& scene, const Symmetry& symmetry) {
    const ShotTrace original = simulate(scene);
    const ShotTrace image = simulate(image_of(scene, symmetry));
    ASSERT_EQ(original.outcome, image.outcome);
    ASSERT_EQ(original.events.size(), image.events.size());
    for (std::size_t i = 0; i < original.events.size(); ++i)
        ASSERT_EQ(original.events[i].t, image.events[i].t) << "event " << i;
    for (std::size_t i = 0; i < original.balls.size(); ++i) {
        const FinalBall& ball = original.balls[i];
        const FinalBall& other = image.balls[renumbered(symmetry, i, original.balls.size())];
        ASSERT_EQ(ball.motion, other.motion);
        ASSERT_TRUE(same(mirrored(symmetry, ball.state.r), other.state.r)) << "ball " << i;
        ASSERT_TRUE(same(mirrored(symmetry, ball.state.v), other.state.v)) << "ball " << i;
        ASSERT_TRUE(same(mirrored_spin(symmetry, ball.state.w), other.state.w)) << "ball " << i;
    }
}

class EverySymmetry : public ::testing::TestWithParam<std::tuple<Symmetry, SolverKind>> {
  protected:
    static void expect_same_shot(Scene scene) {
        scene.solver.kind = std::get<SolverKind>(GetParam());
        expect_image(scene, std::get<Symmetry>(GetParam()));
    }
};

INSTANTIATE_TEST_SUITE_P(
    Symmetries, EverySymmetry,
    ::testing::Combine(::testing::Values(Symmetry{"mirrored_in_x", {-1, 1}, false},
                                         Symmetry{"mirrored_in_y", {1, -1}, false},
                                         Symmetry{"renumbered", {1, 1}, true},
                                         Symmetry{"turned_and_renumbered", {-1, -1}, true}),
                       ::testing::ValuesIn(testing::kSweptSolvers)),
    [](const auto& test) {
        return std::string(std::get<Symmetry>(test.param).name) + "_by_" +
               std::string(name(std::get<SolverKind>(test.param)));
    });

TEST_P(EverySymmetry, RandomTablesGiveTheSameShotToTheBit) {
    testing::Random random(21);
    for (int i = 0; i < 300; ++i) {
        Scene scene = testing::random_scene(random, 2 + random.below(15), random.uniform(0.5, 30));
        if (i % 3 == 1) scene.table.pockets = PocketModel::kEndGame;
        if (i % 5 == 1) {
            scene.effects.rail.model = RailModel::kRestitution;
            scene.effects.rail.e = 0.8;
        }
        SCOPED_TRACE(i);
        expect_same_shot(scene);
    }
}

TEST_P(EverySymmetry, FrozenRacksAndDoubleHitsGiveTheSameShotToTheBit) {
    testing::Random random(22);
    for (int i = 0; i < 100; ++i) {
        Scene scene = testing::break_scene(2 + i % 4, i % 2 == 0 ? 0 : 1e-5, random.uniform(1, 12));
        if (i % 3 != 0) scene.strike->direction.y = random.uniform(-0.05, 0.05);
        SCOPED_TRACE(i);
        expect_same_shot(scene);
    }
}

TEST_P(EverySymmetry, ShotsOnClothGiveTheSameToTheBit) {
    testing::Random random(23);
    for (int i = 0; i < 100; ++i) {
        Scene scene = testing::random_scene(random, 2 + random.below(15), random.uniform(0.5, 12));
        scene.effects = i % 2 == 0 ? testing::cloth_effects() : testing::pool_effects();
        scene.strike->offset = random.uniform(0, 0.6) * random.direction();
        for (SceneBall& ball : scene.balls)
            ball.state.w = {0, 0, random.uniform(-20, 20)};
        if (i % 3 == 1) scene.table.pockets = PocketModel::kPool;
        if (check(scene)) continue;  // a ball in a mouth
        SCOPED_TRACE(i);
        expect_same_shot(scene);
    }
}

TEST_P(EverySymmetry, PressedClustersGiveTheSameToTheBit) {
    testing::Random random(24);
    for (int i = 0; i < 100; ++i) {
        const Scene scene = testing::pressed_scene(random);
        if (check(scene)) continue;  // a ball in a mouth
        SCOPED_TRACE(i);
        expect_same_shot(scene);
    }
}

TEST_P(EverySymmetry, RacksOnClothGiveTheSameToTheBit) {
    testing::Random random(24);
    for (int i = 0; i < 40; ++i) {
        Scene scene =
            testing::break_scene(2 + i % 4, i % 2 == 0 ? 1e-3 : 1e-5, random.uniform(1, 12));
        scene.effects = testing::cloth_effects();
        if (i % 3 != 0) scene.strike->direction.y = random.uniform(-0.05, 0.05);
        scene.limits.events = 200;
        SCOPED_TRACE(i);
        expect_same_shot(scene);
    }
}

TEST(MirrorSymmetry, SymmetricBreakStaysSymmetricToTheBit) {
    const Scene scene = testing::break_scene(5, 0, 9);
    const ShotTrace trace = simulate(scene);
    // Row by row, ball i of a row is the image of the one as far from its other end.
    std::size_t first = 1;
    for (std::size_t row = 0; row < 5; first += ++row) {
        for (std::size_t i = 0; i <= row; ++i) {
            const Vec3 r = trace.balls[first + i].state.r;
            const Vec3 image = trace.balls[first + row - i].state.r;
            EXPECT_TRUE(same({r.x, -r.y, 0}, image)) << "row " << row << " ball " << i;
        }
    }
}

}  // namespace
}  // namespace poolhall
