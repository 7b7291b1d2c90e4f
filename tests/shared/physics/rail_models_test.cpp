#include "shared/physics/contact/han_rail.hpp"
#include "shared/physics/contact/mathavan_rail.hpp"
#include "tests/shared/random.hpp"
#include "tests/shared/reference.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace poolhall {
namespace {

constexpr double kUlp = 0x1p-52;

using Bounce = void (*)(const RailContact&, Vec3&, Vec3&);

struct Model {
    const char* name;
    Bounce bounce;
};

constexpr std::array kModels{Model{"Han", &bounce_han2005}, Model{"Mathavan", &bounce_mathavan2010},
                             Model{"MathavanFast", &bounce_mathavan2010_fast}};

struct Ball {
    Vec3 v;
    Vec3 w;

    friend bool operator==(const Ball&, const Ball&) = default;
};

/// A pool table's rail.
RailContact pool_rail() {
    return {{0, 1}, 0.028575, 0.170097, 0.036576, 0.85, 0.2, 0.2};
}

Ball after(Bounce bounce, const RailContact& rail, Ball ball) {
    bounce(rail, ball.v, ball.w);
    return ball;
}

Ball after(const ImpactPrecision& precision, const RailContact& rail, Ball ball) {
    bounce_mathavan2010(rail, precision, ball.v, ball.w);
    return ball;
}

/// The distance of two results in m/s.
double distance(const Ball& a, const Ball& b, double radius) {
    return std::max(norm(a.v - b.v), radius * norm(a.w - b.w));
}

double energy(const Ball& ball, double radius) {
    return dot(ball.v, ball.v) + 0.4 * radius * radius * dot(ball.w, ball.w);
}

/// Any motion on the cloth into the rail, up to 5 m/s, with up to 140 rad/s of spin.
Ball random_ball(testing::Random& random, const RailContact& rail) {
    const Vec2 direction = random.direction();
    const Vec2 v =
        random.uniform(0.01, 5) * (dot(direction, rail.normal) > 0 ? direction : -direction);
    const auto spin = [&] { return random.uniform(-80, 80); };
    return {{v.x, v.y, 0}, {spin(), spin(), spin()}};
}

/// A rail that a billiards table could have.
RailContact random_rail(testing::Random& random) {
    RailContact rail = pool_rail();
    rail.nose_height = rail.radius * random.uniform(1.1, 1.4);
    rail.e = random.uniform(0.5, 1);
    rail.mu = random.uniform(0.05, 0.4);
    rail.mu_table = random.uniform(0.05, 0.4);
    return rail;
}

struct ReferenceImpact {
    RailContact rail;
    Ball before;
    Ball after;
};

Vec3 vec3(const nlohmann::json& a) {
    return {a.at(0), a.at(1), a.at(2)};
}

std::vector<ReferenceImpact> reference_impacts(const std::string& model) {
    std::ifstream file(POOLHALL_REFERENCE_FOLDER "/rail_impacts.json");
    const nlohmann::json all = nlohmann::json::parse(file);
    const nlohmann::json& p = all.at("parameters");
    std::vector<ReferenceImpact> impacts;
    for (const nlohmann::json& one : all.at("impacts")) {
        if (one.at("model") != model) continue;
        const Vec2 normal{one.at("normal").at(0), one.at("normal").at(1)};
        const auto ball = [&](const char* when) {
            return Ball{vec3(one.at(when).at("v")), vec3(one.at(when).at("w"))};
        };
        impacts.push_back({{normal, p.at("radius"), p.at("mass"), p.at("nose_height"), p.at("e"),
                            p.at("mu"), p.at("mu_table")},
                           ball("before"),
                           ball("after")});
    }
    return impacts;
}

TEST(HanRail, AgreesWithPooltool) {
    const auto impacts = reference_impacts("han_2005");
    EXPECT_EQ(impacts.size(), 13U);
    for (const ReferenceImpact& one : impacts) {
        const Ball here = after(&bounce_han2005, one.rail, one.before);
        EXPECT_LT(distance(here, one.after, one.rail.radius), 3e-15);
    }
}

TEST(HanRail, WithoutFrictionLosesWhatTheInclinedNoseTakes) {
    RailContact rail = pool_rail();
    rail.mu = 0;
    const double sin_theta = rail.nose_height / rail.radius - 1;
    const double kept = sin_theta * sin_theta - rail.e * (1 - sin_theta * sin_theta);
    const Ball here = after(&bounce_han2005, rail, {{1, 2, 0}, {3, 4, 5}});
    EXPECT_EQ(here.v.x, 1);
    EXPECT_NEAR(here.v.y, 2 * kept, 4 * kUlp);
    EXPECT_EQ(here.w, (Vec3{3, 4, 5}));
}

TEST(MathavanRail, AgreesWithPooltoolAsWellAsItsSteps) {
    const auto impacts = reference_impacts("mathavan_2010_fine");
    EXPECT_EQ(impacts.size(), 8U);
    for (const ReferenceImpact& one : impacts) {
        const Ball here = after(&bounce_mathavan2010, one.rail, one.before);
        EXPECT_LT(distance(here, one.after, one.rail.radius), 4e-6);
    }
    for (const ReferenceImpact& one : reference_impacts("mathavan_2010_default")) {
        const Ball here = after(&bounce_mathavan2010, one.rail, one.before);
        EXPECT_LT(distance(here, one.after, one.rail.radius), 1e-2);
    }
}

TEST(MathavanRail, WithoutFrictionTurnsTheNormalVelocityRound) {
    RailContact rail = pool_rail();
    rail.mu = 0;
    rail.mu_table = 0;
    for (const double e : {0.0, 0.5, 0.85, 1.0}) {
        rail.e = e;
        const Ball here = after(&bounce_mathavan2010, rail, {{1, 2, 0}, {3, 4, 5}});
        EXPECT_EQ(here.v.x, 1);
        EXPECT_NEAR(here.v.y, -2 * e, 16 * kUlp);
        EXPECT_EQ(here.w, (Vec3{3, 4, 5}));
    }
}

/// Head-on all rates are constant between the ends of phases: no slip of the ball stops here, and
/// the nose slips down (p < 0), the cloth into the rail (q < 0).
TEST(MathavanRail, HeadOnHasAClosedForm) {
    const RailContact rail = pool_rail();
    const double s = rail.nose_height / rail.radius - 1;
    const double c = std::sqrt(1 - s * s);
    const double load = s - c * rail.mu;  // on the cloth, as the nose lifts
    const double braking = c + s * rail.mu - load * rail.mu_table;
    const double impulse = (1 + rail.e * 1) / braking;
    const double v = 1.5;
    const Ball here = after(&bounce_mathavan2010, rail, {{0, v, 0}, {-4 * v / rail.radius, 0, 0}});
    EXPECT_NEAR(here.v.y, -rail.e * v, 1e-14);
    const double spin = -4 * v + 2.5 * (rail.mu + load * rail.mu_table) * impulse * v;
    EXPECT_NEAR(here.w.x * rail.radius, spin, 1e-13);
    EXPECT_EQ(here.v.x, 0);
    EXPECT_EQ(here.w.z, 0);
}

TEST(MathavanRail, ConvergesFasterThanWithSecondOrder) {
    constexpr double kAnyError = 1e300;
    const Ball ball{{2, 1, 0}, {60, -40, 20}};  // nothing stops
    const RailContact rail = pool_rail();
    const Ball exact = after({1, 1e-12, 1e-9}, rail, ball);
    double last = 0;
    for (const double step : {0.5, 0.25, 0.125}) {
        const double error =
            distance(after({step, kAnyError, 1e-8}, rail, ball), exact, rail.radius);
        EXPECT_LT(error, 1e-4);
        EXPECT_TRUE(last == 0 || last > 4 * error) << step;
        last = error;
    }
}

TEST(MathavanRail, ErrsAsLittleAsItsHeaderSays) {
    testing::Random random(3);
    std::vector<double> exact;
    std::vector<double> fast;
    for (int i = 0; i < 2000; ++i) {
        const RailContact rail = random_rail(random);
        const Ball ball = random_ball(random, rail);
        const Ball best = after({1, 1e-12, 1e-9}, rail, ball);
        const auto error = [&](Bounce bounce) {
            return distance(after(bounce, rail, ball), best, rail.radius) / ball.v.y;
        };
        exact.push_back(error(&bounce_mathavan2010));
        fast.push_back(error(&bounce_mathavan2010_fast));
    }
    std::sort(exact.begin(), exact.end());
    std::sort(fast.begin(), fast.end());
    EXPECT_LT(exact[1000], 1e-8);
    EXPECT_LT(exact[1980], 1e-6);
    EXPECT_LT(exact.back(), 1e-5);
    EXPECT_LT(fast[1000], 4e-6);
    EXPECT_LT(fast[1980], 4e-3);
    EXPECT_LT(fast.back(), 2e-2);
}

TEST(MathavanRail, RoughNoseAndClothWedgeTheBall) {
    RailContact rail = pool_rail();
    rail.mu = 1;
    rail.mu_table = 1;
    const Ball here = after(&bounce_mathavan2010, rail, {{0, 1, 0}, {-1 / rail.radius, 0, 0}});
    EXPECT_LE(here.v.y, 0);
    EXPECT_GT(here.v.y, -1e-3);
}

class EveryRailModel : public ::testing::TestWithParam<Model> {};

INSTANTIATE_TEST_SUITE_P(Models, EveryRailModel, ::testing::ValuesIn(kModels),
                         [](const auto& test) { return test.param.name; });

TEST_P(EveryRailModel, LeavesABallThatDoesNotApproach) {
    const Ball along{{2, 0, 0}, {1, 2, 3}};
    const Ball away{{2, -1e-300, 0}, {1, 2, 3}};
    EXPECT_EQ(after(GetParam().bounce, pool_rail(), along), along);
    EXPECT_EQ(after(GetParam().bounce, pool_rail(), away), away);
}

TEST_P(EveryRailModel, LosesEnergyAndLeavesTheRail) {
    testing::Random random(7);
    for (int i = 0; i < 3000; ++i) {
        RailContact rail = random_rail(random);
        if (i % 2 == 0) {
            rail.nose_height = rail.radius * random.uniform(0.05, 1.95);
            rail.e = i % 4 == 0 ? 1 : random.uniform(0, 1);
            rail.mu = random.uniform(0, 1.5);
            rail.mu_table = random.uniform(0, 1.5);
        }
        const Ball ball = random_ball(random, rail);
        const Ball here = after(GetParam().bounce, rail, ball);
        const double before = energy(ball, rail.radius);
        EXPECT_LE(energy(here, rail.radius), before * (1 + 8 * kUlp)) << i;
        EXPECT_LE(here.v.y, 0) << i;
        EXPECT_EQ(here.v.z, 0);
    }
}

TEST_P(EveryRailModel, MirrorsToTheBit) {
    testing::Random random(11);
    for (int i = 0; i < 1000; ++i) {
        const RailContact rail = random_rail(random);
        const Ball ball = random_ball(random, rail);
        const Ball here = after(GetParam().bounce, rail, ball);
        const auto mirrored = [](const Ball& a) {
            return Ball{{-a.v.x, a.v.y, a.v.z}, {a.w.x, -a.w.y, -a.w.z}};
        };
        EXPECT_EQ(after(GetParam().bounce, rail, mirrored(ball)), mirrored(here));
    }
}

TEST_P(EveryRailModel, TurnsWithTheRail) {
    testing::Random random(13);
    for (int i = 0; i < 1000; ++i) {
        RailContact rail = pool_rail();
        const Ball ball = random_ball(random, rail);
        const Ball here = after(GetParam().bounce, rail, ball);
        const Vec2 n = normalized(random.direction());
        const auto turned = [&](const Vec3& a) {
            return Vec3{a.x * n.y + a.y * n.x, a.y * n.y - a.x * n.x, a.z};
        };
        rail.normal = n;
        const Ball there = after(GetParam().bounce, rail, {turned(ball.v), turned(ball.w)});
        const double tolerance = GetParam().bounce == &bounce_han2005 ? 1e-14 : 1e-5;
        EXPECT_LT(distance(there, {turned(here.v), turned(here.w)}, rail.radius),
                  tolerance * (norm(ball.v) + rail.radius * norm(ball.w)));
    }
}

TEST_P(EveryRailModel, ScalesWithTheSpeed) {
    testing::Random random(17);
    for (const double scale : {0x1p-990, 0x1p-300, 0x1p20}) {
        for (int i = 0; i < 100; ++i) {
            const RailContact rail = pool_rail();
            const Ball ball = random_ball(random, rail);
            const Ball here = after(GetParam().bounce, rail, ball);
            const Ball there = after(GetParam().bounce, rail, {scale * ball.v, scale * ball.w});
            EXPECT_EQ(there, (Ball{scale * here.v, scale * here.w}));
        }
    }
}

TEST_P(EveryRailModel, TreatsAGrazeLikeAnyImpact) {
    const RailContact rail = pool_rail();
    for (const double graze : {5e-324, 1e-300, 1e-100, 1e-12}) {
        const Ball ball{{2, graze, 0}, {0, 2 / rail.radius, 10}};
        const Ball here = after(GetParam().bounce, rail, ball);
        EXPECT_LE(here.v.y, 0);
        EXPECT_GE(here.v.y, -graze);
        EXPECT_NEAR(here.v.x, 2, 1e-11);
        EXPECT_NEAR(here.w.z, 10, 1e-9);
    }
}

}  // namespace
}  // namespace poolhall
