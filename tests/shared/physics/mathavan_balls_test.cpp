#include "shared/physics/contact/mathavan_balls.hpp"

#include "tests/shared/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

namespace poolhall {
namespace {

constexpr double kRadius = 0.02625;
constexpr double kMass = 0.1406;
constexpr double kDegree = std::numbers::pi / 180;

/// The velocity of a ball on the cloth once it rolls.
Vec2 settled(const ImpactBall& ball) {
    const Vec2 slip{ball.v.x - ball.radius * ball.w.y, ball.v.y + ball.radius * ball.w.x};
    return xy(ball.v) - (2.0 / 7) * slip;
}

double angle_of(Vec2 v) {
    return std::atan2(v.y, v.x) / kDegree;
}

struct Row {
    double speed;   ///< of the cue ball, which rolls; m/s
    double cut;     ///< angle of the line of centres, degrees
    double cue;     ///< m/s, after the slip
    double object;  ///< m/s, after the slip
    double angle;   ///< of the cue ball, degrees
};

// "M14's own model" of the five shots of Mathavan, Jackson, Parkin, Am. J. Phys. 77(9), 2009: with
// e 0.89, mu 0.05 and 0.21 at the cloth, the cut being that of the line of centres.
constexpr std::array kPublished{
    Row{1.539, 33.83, 0.914, 0.831, 31.93}, Row{1.032, 26.36, 0.520, 0.599, 32.45},
    Row{1.364, 40.52, 0.917, 0.676, 29.91}, Row{1.731, 46.50, 1.28, 0.780, 27.32},
    Row{0.942, 18.05, 0.383, 0.579, 29.47},
};

TEST(MathavanBalls, GiveThePublishedResultsOfTheModel) {
    for (const Row& row : kPublished) {
        ImpactBall cue{{row.speed, 0, 0}, {0, row.speed / kRadius, 0}, kRadius, kMass};
        ImpactBall object{{}, {}, kRadius, kMass};
        const double cut = row.cut * kDegree;
        collide_mathavan2014({0.89, 0.05, 0.21}, {std::cos(cut), std::sin(cut), 0}, cue, object);
        EXPECT_NEAR(row.cue, norm(settled(cue)), 0.0025) << row.speed;
        EXPECT_NEAR(row.object, norm(settled(object)), 0.0015) << row.speed;
        EXPECT_NEAR(row.angle, -angle_of(settled(cue)), 0.03) << row.speed;
    }
}

struct Impact {
    BallsOnCloth coefficients;
    Vec3 n;
    ImpactBall a;
    ImpactBall b;
};

Impact random_impact(testing::Random& random) {
    const auto ball = [&] {
        const Vec2 v = random.uniform(0, 5) * random.direction();
        const Vec2 w = random.uniform(0, 200) * random.direction();
        return ImpactBall{{v.x, v.y, 0},
                          {w.x, w.y, random.uniform(-100, 100)},
                          random.uniform(0.02, 0.04),
                          random.uniform(0.1, 0.3)};
    };
    const Vec2 n = random.direction();
    Impact impact{{random.uniform(0, 1), random.uniform(0, 0.2), random.uniform(0, 0.5)},
                  normalized(Vec3{n.x, n.y, 0}),
                  ball(),
                  ball()};
    if (random.below(3) == 0) impact.b.v = impact.b.w = {};
    if (!(dot(impact.a.v - impact.b.v, impact.n) > 0)) std::swap(impact.a.v, impact.b.v);
    return impact;
}

double energy(const ImpactBall& ball) {
    return ball.mass *
           (dot(ball.v, ball.v) / 2 + ball.radius * ball.radius * dot(ball.w, ball.w) / 5);
}

/// The same in many small steps by Newton's laws, in space and with no ball told to be the pressed
/// one.
void collide_in_steps(Impact& impact, int steps) {
    auto& [coefficients, n, a, b] = impact;
    const auto approach = [&] { return dot(a.v - b.v, n); };
    const double step = approach() * (a.mass * b.mass / (a.mass + b.mass)) / steps;
    const auto rub_on_cloth = [&](ImpactBall& ball, double load) {
        const Vec2 slip{ball.v.x - ball.radius * ball.w.y, ball.v.y + ball.radius * ball.w.x};
        const double speed = norm(slip);
        const double impulse = std::min(coefficients.mu_table * load, 2 * ball.mass * speed / 7);
        if (speed == 0) return;
        const Vec2 j = (impulse / speed) * slip;
        set_xy(ball.v, xy(ball.v) - (1 / ball.mass) * j);
        const double turn = 2.5 / (ball.mass * ball.radius);
        ball.w = ball.w + turn * Vec3{-j.y, j.x, 0};
    };
    double work = 0;
    double compression = -1;
    while (compression < 0 || work > (1 - coefficients.e * coefficients.e) * compression) {
        if (compression < 0 && approach() <= 0) compression = work;
        if (compression >= 0 && work <= (1 - coefficients.e * coefficients.e) * compression) break;
        const double before = approach();
        const Vec3 slip = slip_velocity(n, a, b);
        const double speed = norm(slip);
        // Of the vertical slip only spin takes part: each ball stays on the cloth.
        const Vec3 j = speed > 1e-6 ? (coefficients.mu * step / speed) * slip : Vec3{};
        a.v = a.v - (step / a.mass) * n;
        b.v = b.v + (step / b.mass) * n;
        apply_tangential(j, n, VerticalPart::kToSlate, a, b);
        rub_on_cloth(j.z > 0 ? a : b, std::abs(j.z));
        work += step * (before + approach()) / 2;
    }
}

TEST(MathavanBalls, AgreeWithTheLawsOfMotionInSmallSteps) {
    testing::Random random(81);
    double worst = 0;
    for (int i = 0; i < 300; ++i) {
        const Impact before = random_impact(random);
        if (!(dot(before.a.v - before.b.v, before.n) > 0.1)) continue;
        Impact exact = before;
        collide_mathavan2014(before.coefficients, before.n, exact.a, exact.b);
        Impact steps = before;
        collide_in_steps(steps, 20000);
        worst = std::max({worst, norm(exact.a.v - steps.a.v), norm(exact.b.v - steps.b.v),
                          exact.a.radius * norm(exact.a.w - steps.a.w),
                          exact.b.radius * norm(exact.b.w - steps.b.w)});
    }
    RecordProperty("worst_um_s", static_cast<int>(1e6 * worst));
    EXPECT_LT(worst, 3e-3);
}

TEST(MathavanBalls, KeepMomentumButForTheClothAndNeverGainEnergy) {
    testing::Random random(82);
    for (int i = 0; i < 20000; ++i) {
        Impact impact = random_impact(random);
        if (!(dot(impact.a.v - impact.b.v, impact.n) > 0)) continue;
        if (i % 2 == 0) impact.coefficients.mu_table = 0;
        const Vec3 momentum = impact.a.mass * impact.a.v + impact.b.mass * impact.b.v;
        const double had = energy(impact.a) + energy(impact.b);
        const double approach = dot(impact.a.v - impact.b.v, impact.n);
        collide_mathavan2014(impact.coefficients, impact.n, impact.a, impact.b);
        EXPECT_LE(energy(impact.a) + energy(impact.b), had * (1 + 1e-9)) << i;
        const double leaves = dot(impact.b.v - impact.a.v, impact.n);
        if (impact.coefficients.mu_table > 0) {
            EXPECT_GE(leaves, -1e-9) << i;
            continue;
        }
        EXPECT_LT(norm(impact.a.mass * impact.a.v + impact.b.mass * impact.b.v - momentum), 1e-12);
        EXPECT_NEAR(impact.coefficients.e * approach, leaves, 1e-9 * approach);
    }
}

TEST(MathavanBalls, AreIntegratedAsExactlyAsTheySay) {
    testing::Random random(84);
    std::vector<double> errors;
    for (int i = 0; i < 5000; ++i) {
        const Impact impact = random_impact(random);
        const double approach = dot(impact.a.v - impact.b.v, impact.n);
        if (!(approach > 0)) continue;
        Impact rough = impact;
        Impact fine = impact;
        fine.coefficients.tolerance = 1e-13;
        collide_mathavan2014(rough.coefficients, rough.n, rough.a, rough.b);
        collide_mathavan2014(fine.coefficients, fine.n, fine.a, fine.b);
        errors.push_back(std::max({norm(rough.a.v - fine.a.v), norm(rough.b.v - fine.b.v),
                                   rough.a.radius * norm(rough.a.w - fine.a.w),
                                   rough.b.radius * norm(rough.b.w - fine.b.w)}) /
                         approach);
    }
    std::sort(errors.begin(), errors.end());
    RecordProperty("median_e15", static_cast<int>(1e15 * errors[errors.size() / 2]));
    RecordProperty("p99_e15", static_cast<int>(1e15 * errors[errors.size() * 99 / 100]));
    RecordProperty("worst_e15", static_cast<int>(1e15 * std::min(1e-6, errors.back())));
    EXPECT_LT(errors[errors.size() / 2], 1e-9);
    EXPECT_LT(errors.back(), 1e-7);
}

TEST(MathavanBalls, HaveNoOrder) {
    testing::Random random(83);
    for (int i = 0; i < 1000; ++i) {
        Impact impact = random_impact(random);
        if (!(dot(impact.a.v - impact.b.v, impact.n) > 0)) continue;
        Impact turned{impact.coefficients, -1 * impact.n, impact.b, impact.a};
        collide_mathavan2014(impact.coefficients, impact.n, impact.a, impact.b);
        collide_mathavan2014(turned.coefficients, turned.n, turned.a, turned.b);
        EXPECT_EQ(impact.a.v, turned.b.v);
        EXPECT_EQ(impact.a.w, turned.b.w);
        EXPECT_EQ(impact.b.v, turned.a.v);
        EXPECT_EQ(impact.b.w, turned.a.w);
    }
}

// Kim, arXiv:2402.13258: on rough cloth a rolling ball that hits another in the middle goes back
// for a moment, for the friction of the other lifts it and presses that one.
TEST(MathavanBalls, StunNeedsNoClothAndFollowPressesTheObjectBall) {
    const Vec3 n{1, 0, 0};
    ImpactBall cue{{2, 0, 0}, {}, kRadius, kMass};
    ImpactBall object{{}, {}, kRadius, kMass};
    collide_mathavan2014({1, 0.06, 0.4}, n, cue, object);
    EXPECT_NEAR(0, cue.v.x, 1e-12);
    EXPECT_NEAR(2, object.v.x, 1e-12);
    cue = {{2, 0, 0}, {0, 2 / kRadius, 0}, kRadius, kMass};
    object = {{}, {}, kRadius, kMass};
    collide_mathavan2014({1, 0.06, 0.4}, n, cue, object);
    EXPECT_LT(cue.v.x, -0.001);
    EXPECT_LT(object.v.x, 2);
    EXPECT_LT(object.w.y, 0) << "turned back by the cue ball, forwards only by the cloth";
}

TEST(MathavanBalls, EndForAnyInput) {
    const std::array kSizes{0.0, 5e-324, 1e-200, 1e-9, 1.0, 1e6};
    for (const double approach : kSizes) {
        if (approach == 0) continue;
        for (const double spin : kSizes) {
            for (const double mu : {0.0, 0.06, 1.0, 10.0}) {
                ImpactBall cue{{approach, spin, 0}, {spin, -spin, 3 * spin}, kRadius, kMass};
                ImpactBall object{{}, {0, spin / 2, 0}, kRadius, 1e6 * kMass};
                collide_mathavan2014({0.9, mu, mu}, {1, 0, 0}, cue, object);
                EXPECT_TRUE(std::isfinite(cue.v.x) && std::isfinite(cue.w.z)) << approach;
                EXPECT_TRUE(std::isfinite(object.v.y) && std::isfinite(object.w.y)) << spin;
            }
        }
    }
}

}  // namespace
}  // namespace poolhall
