// Slide, roll and rest of one ball against closed forms, for all solvers that know the cloth.

#include "tests/shared/quad.hpp"
#include "tests/shared/random.hpp"
#include "tests/shared/reference.hpp"
#include "tests/shared/scenes.hpp"
#include "tests/shared/solvers.hpp"
#include "tests/shared/traces.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace poolhall {
namespace {

using testing::events_of;
using testing::final_place;
using testing::Quad;

Scene on_endless_cloth(Vec2 v, Vec2 w, SolverSpec solver) {
    Scene scene = testing::scene_of({0, 0}, v);
    scene.balls[0].state.w = {w.x, w.y, 0};
    scene.table.rails = false;
    scene.effects = testing::cloth_effects();
    scene.solver = solver;
    return scene;
}

Scene scene_of(const testing::ReferenceCase& one, SolverSpec solver) {
    Scene scene = on_endless_cloth({one.input("v0", 0), one.input("v0", 1)},
                                   {one.input("w0", 0), one.input("w0", 1)}, solver);
    scene.ball.radius = one.input("R");
    scene.gravity = one.input("g");
    scene.effects.sliding->mu = one.input("mu_s");
    scene.effects.rolling->mu = one.input("mu_r");
    return scene;
}

void expect_near(Vec2 expected, Vec2 actual, double relative) {
    EXPECT_LE(norm(actual - expected), relative * norm(expected)) << actual.x << " " << actual.y;
}

Vec2 expected_vector(const testing::ReferenceCase& one, const char* name) {
    return {one.expected(name, 0), one.expected(name, 1)};
}

class ClosedForm : public ::testing::TestWithParam<SolverKind> {};

INSTANTIATE_TEST_SUITE_P(Solvers, ClosedForm, ::testing::ValuesIn(testing::kClosedFormSolvers),
                         testing::solver_name);

TEST_P(ClosedForm, SlideRollAndRestFromAnySpinAgreeWithTheReference) {
    for (const auto& one : testing::reference_cases("a_slide_roll_rest")) {
        SCOPED_TRACE(one.id);
        const ShotTrace trace = simulate(scene_of(one, {GetParam(), 30}));
        ASSERT_EQ(Outcome::kRest, trace.outcome);
        const auto slides = events_of(trace, EventKind::kSlideToRoll);
        // Natural roll slips by the rounding of its spin only, which is no slide.
        if (one.expected("t_slide") > 1e-12) {
            ASSERT_EQ(1U, slides.size());
            EXPECT_NEAR(1, slides[0].t / one.expected("t_slide"), 1e-13);
            expect_near(expected_vector(one, "pos_roll"), xy(slides[0].after[0].r), 1e-13);
            // What is left of a full draw is the rounding of what was given.
            EXPECT_LE(norm(xy(slides[0].after[0].v) - expected_vector(one, "v_roll")),
                      1e-13 * norm(expected_vector(one, "v_roll")) + 0x1p-53);
        } else {
            EXPECT_TRUE(slides.empty());
        }
        const auto rests = events_of(trace, EventKind::kRollToRest);
        ASSERT_EQ(1U, rests.size());
        EXPECT_NEAR(1, rests[0].t / one.expected("t_rest"), 1e-13);
        expect_near(expected_vector(one, "pos_rest"), final_place(trace, 0), 1e-13);
    }
}

TEST_P(ClosedForm, FullDrawThatStopsDeadLeavesNoVelocityOver) {
    for (const double speed : {1e-9, 0.3, 2.0, 30.0}) {
        // v = 2/7 u: the friction that ends the slip takes all of the velocity.
        const double spin = -2.5 * speed / BallSpec{}.radius;
        const ShotTrace trace = simulate(on_endless_cloth({speed, 0}, {0, spin}, {GetParam(), 30}));
        const auto slides = events_of(trace, EventKind::kSlideToRoll);
        const auto rests = events_of(trace, EventKind::kRollToRest);
        ASSERT_EQ(1U, slides.size());
        ASSERT_EQ(1U, rests.size());
        EXPECT_NEAR(1, slides[0].t / (speed / (0.2 * 9.81)), 1e-13);
        EXPECT_EQ(slides[0].t, rests[0].t);
        EXPECT_EQ(Vec3{}, trace.balls[0].state.v);
        EXPECT_EQ(Vec3{}, trace.balls[0].state.w);
    }
}

struct QuadVec {
    Quad x, y;
};

/// Where and when a ball from the origin comes to rest, in 113-bit arithmetic.
struct Rest {
    QuadVec r;
    Quad t;
    double after_slide;  ///< m/s
};

Rest rest_of(Vec2 v, Vec2 w) {
    const Quad radius = BallSpec{}.radius;
    const Quad gravity = 9.81;
    const Quad sliding = Quad{0.2} * gravity;
    const Quad rolling = Quad{0.01} * gravity;
    const QuadVec u{v.x - radius * w.y, v.y + radius * w.x};
    const Quad slip = testing::sqrt(u.x * u.x + u.y * u.y);
    const Quad t_slide = 2 * slip / (7 * sliding);
    const QuadVec after{v.x - 2 * u.x / 7, v.y - 2 * u.y / 7};
    const Quad speed = testing::sqrt(after.x * after.x + after.y * after.y);
    const Quad t_roll = speed / rolling;
    return {{(v.x + after.x) * t_slide / 2 + after.x * t_roll / 2,
             (v.y + after.y) * t_slide / 2 + after.y * t_roll / 2},
            t_slide + t_roll,
            testing::to_double(speed)};
}

TEST_P(ClosedForm, RandomSpinsFromANanometreASecondTo30AgreeWith113BitArithmetic) {
    testing::Random random(61);
    int compared = 0;
    for (int i = 0; i < 2000; ++i) {
        const double speed = i % 2 == 0 ? random.uniform(0.01, 30) : random.uniform(1e-9, 1e-6);
        const Vec2 v = speed * random.direction();
        const Vec2 w = (random.uniform(0, 3) * speed / BallSpec{}.radius) * random.direction();
        const Rest rest = rest_of(v, w);
        // Near a dead stop the little that is left is all rounding of what was given.
        if (rest.after_slide < 0.1 * norm(v)) continue;
        ++compared;
        const ShotTrace trace = simulate(on_endless_cloth(v, w, {GetParam(), 30}));
        ASSERT_EQ(Outcome::kRest, trace.outcome);
        EXPECT_LE(testing::relative_error(trace.duration, rest.t), 1e-13);
        expect_near({testing::to_double(rest.r.x), testing::to_double(rest.r.y)},
                    final_place(trace, 0), 1e-13);
    }
    EXPECT_GT(compared, 1500);
}

TEST_P(ClosedForm, SideSpinDecaysAtItsRateAndMovesNoCentre) {
    for (const double spin : {100.0, -100.0, 1e-9}) {
        Scene scene = on_endless_cloth({1, 0}, {0, 0}, {GetParam(), 30});
        scene.effects.spin_decay = SpinDecaySpec{0.0127};
        const Vec2 without = final_place(simulate(scene), 0);
        scene.balls[0].state.w.z = spin;
        const double decay = 5 * 0.0127 * 9.81 / (2 * BallSpec{}.radius);
        const ShotTrace trace = simulate(scene);
        EXPECT_EQ(without, final_place(trace, 0));
        EXPECT_EQ(Vec3{}, trace.balls[0].state.w);
        const auto spins = events_of(trace, EventKind::kSpinToRest);
        if (std::abs(spin) < 1) {
            EXPECT_TRUE(spins.empty());
            continue;
        }
        ASSERT_EQ(1U, spins.size());
        EXPECT_NEAR(1, spins[0].t / (std::abs(spin) / decay), 1e-13);
    }
}

class Stepper : public ::testing::TestWithParam<SolverKind> {};

INSTANTIATE_TEST_SUITE_P(Solvers, Stepper,
                         ::testing::Values(SolverKind::kEuler, SolverKind::kSemiImplicit),
                         testing::solver_name);

/// Root mean square of the error of the resting place over random shots, m.
double mean_error(SolverSpec solver) {
    testing::Random random(62);
    constexpr int kShots = 60;
    double sum = 0;
    for (int i = 0; i < kShots; ++i) {
        const Vec2 v = random.uniform(0.5, 4) * random.direction();
        const Vec2 w = random.uniform(0, 100) * random.direction();
        const Rest rest = rest_of(v, w);
        const Vec2 error = final_place(simulate(on_endless_cloth(v, w, solver)), 0) -
                           Vec2{testing::to_double(rest.r.x), testing::to_double(rest.r.y)};
        sum += dot(error, error);
    }
    return std::sqrt(sum / kShots);
}

/// Slope of the straight line through the points (i, y_i) by least squares.
double slope(const std::vector<double>& y) {
    const double mean_x = static_cast<double>(y.size() - 1) / 2;
    double along = 0;
    double square = 0;
    for (std::size_t i = 0; i < y.size(); ++i) {
        const double x = static_cast<double>(i) - mean_x;
        along += x * y[i];
        square += x * x;
    }
    return along / square;
}

TEST_P(Stepper, ErrorFallsAsTheRateRises) {
    std::vector<double> halvings;
    for (const double hz : {60, 120, 240, 480, 960, 1920})
        halvings.push_back(-std::log2(mean_error({GetParam(), hz})));
    EXPECT_NEAR(1, slope(halvings), 0.1);
}

TEST_P(Stepper, FullDrawThatStopsDeadLeavesNoVelocityOver) {
    const double spin = -2.5 * 2 / BallSpec{}.radius;
    const ShotTrace trace = simulate(on_endless_cloth({2, 0}, {0, spin}, {GetParam(), 120}));
    ASSERT_EQ(Outcome::kRest, trace.outcome);
    EXPECT_NEAR(2 / (0.2 * 9.81), trace.duration, 2.0 / 120);
    EXPECT_EQ(Vec3{}, trace.balls[0].state.v);
}

}  // namespace
}  // namespace poolhall
