#include "shared/physics/contact/time_of_impact.hpp"

#include "shared/table/ball.hpp"
#include "tests/shared/quad.hpp"
#include "tests/shared/random.hpp"
#include "tests/shared/reference.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace poolhall {
namespace {

using testing::Quad;
using testing::relative_error;

constexpr double kDiameter = 2 * BallSpec{}.radius;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Ball a stays at the origin, b has what the reference calls relative position and velocity.
std::optional<double> relative_toi(Vec2 c, Vec2 v, double distance = kDiameter) {
    return time_of_impact({{}, {}}, {c, v}, distance);
}

/// The textbook's formula in 113 bits; nothing for a miss.
std::optional<Quad> exact_toi(const UniformMotion& a, const UniformMotion& b, double distance) {
    const Quad cx = Quad{b.r.x} - a.r.x;
    const Quad cy = Quad{b.r.y} - a.r.y;
    const Quad vx = Quad{b.v.x} - a.v.x;
    const Quad vy = Quad{b.v.y} - a.v.y;
    const Quad d = distance;
    const Quad approach = -(cx * vx + cy * vy);
    const Quad area = cx * vy - cy * vx;
    const Quad q = (vx * vx + vy * vy) * d * d - area * area;
    if (approach <= 0 || q < 0) return std::nullopt;
    return (cx * cx + cy * cy - d * d) / (approach + testing::sqrt(q));
}

TEST(TimeOfImpact, AgreesWithTheReferenceOfExtremeSpeeds) {
    for (const auto& one : testing::reference_cases("h_extremes")) {
        SCOPED_TRACE(one.id);
        const auto t = relative_toi({one.input("dp", 0), one.input("dp", 1)},
                                    {one.input("dv", 0), one.input("dv", 1)});
        if (one.expect.at("hit") == "overlap") {
            EXPECT_EQ(0, t.value());
        } else if (one.expect.at("hit") == true) {
            // denormal_v: the time itself is beyond the doubles.
            EXPECT_DOUBLE_EQ(one.expected("t"), t.value());
        } else {
            EXPECT_FALSE(t);
        }
    }
}

TEST(TimeOfImpact, AgreesWithTheReferenceNearGrazing) {
    int checked = 0;
    for (const auto& one : testing::reference_cases("i_seed_cancellation")) {
        if (!one.expect.contains("travel_exact")) continue;
        SCOPED_TRACE(one.id);
        const Vec2 v{one.input("v", 0), one.input("v", 1)};
        const auto t = time_of_impact({{}, v}, {{one.input("c", 0), one.input("c", 1)}, {}},
                                      one.input("delta"));
        EXPECT_NEAR(1, t.value() * norm(v) / one.expected("travel_exact"), 1e-15);
        ++checked;
    }
    EXPECT_EQ(2, checked);
}

TEST(TimeSinceImpact, AgreesWithTheReferenceForBallsThatLeaveAndThatHaveJustComeIn) {
    int checked = 0;
    for (const auto& one : testing::reference_cases("i_seed_cancellation")) {
        if (!one.expect.contains("d_exact")) continue;
        SCOPED_TRACE(one.id);
        const Vec2 v{one.input("v", 0), one.input("v", 1)};
        const Vec2 c{one.input("c", 0), one.input("c", 1)};
        const double delta = one.input("delta");
        // c leads from the second ball to the first; v is the second's velocity.
        const double away = norm(v) * time_since_impact({c, {}}, {{}, v}, delta);
        const double in = norm(v) * time_since_impact({-c, {}}, {{}, v}, delta);
        EXPECT_NEAR(1, away / one.expected("d_exact"), 1e-15);
        EXPECT_NEAR(1, in / one.expected("d_exact_mirrored"), 1e-15);
        ++checked;
    }
    EXPECT_EQ(11, checked);
}

TEST(TimeSinceImpact, IsFiniteForOverlapsBelowRoundingAndForTheSlowestSpeeds) {
    const double just_inside = std::nextafter(kDiameter, 0);
    for (const Vec2 direction : {Vec2{1, 0}, Vec2{0.6, 0.8}, Vec2{-0.28, 0.96}}) {
        const Vec2 aside{-just_inside * direction.y, just_inside * direction.x};
        for (const double speed : {5e-324, 1e-200, 1e-9, 1.0, 30.0, 1e6}) {
            const double t = time_since_impact({{}, {}}, {aside, speed * direction}, kDiameter);
            EXPECT_FALSE(std::isnan(t)) << speed;
            EXPECT_GE(t, 0) << speed;
        }
    }
}

/// A geometry with the given angle (rad) between the motion and the line of centres' normal at
/// impact, 0 being a graze, and up to 2 m to go; or one that misses by as much as it would hit.
std::pair<UniformMotion, UniformMotion> geometry_at(double angle, bool hit,
                                                    testing::Random& random) {
    const Vec2 along = normalized(random.direction());
    const Vec2 across{-along.y, along.x};
    const double side = random.below(2) == 0 ? 1 : -1;
    const double way = random.uniform(0.001, 2);
    const double speed = random.uniform(0.01, 30);
    const double off_centre = hit ? std::cos(angle) : 2 - std::cos(angle);
    const double offset = side * kDiameter * off_centre;
    const double depth = kDiameter * std::sin(angle);
    const Vec2 drift = random.uniform(0, 5) * random.direction();
    const Vec2 start{random.uniform(-1, 1), random.uniform(-1, 1)};
    return {{start, drift + speed * along},
            {start + (way + depth) * along + offset * across, drift}};
}

class NearGrazing : public ::testing::TestWithParam<double> {};

TEST_P(NearGrazing, TwentyThousandGeometriesHaveTheRightVerdictAndTheTimeTo1e14) {
    testing::Random random(7);
    double worst = 0;
    int hits = 0;
    for (int i = 0; i < 20000; ++i) {
        const auto [a, b] = geometry_at(GetParam(), i % 2 == 0, random);
        const auto exact = exact_toi(a, b, kDiameter);
        const auto actual = time_of_impact(a, b, kDiameter);
        ASSERT_EQ(exact.has_value(), actual.has_value()) << "geometry " << i;
        if (!exact) continue;
        ++hits;
        worst = std::max(worst, relative_error(*actual, *exact));
    }
    RecordProperty("worst_relative_error", std::to_string(worst * 1e15) + "e-15");
    EXPECT_LE(worst, 1e-14);
    EXPECT_GT(hits, 5000);
}

INSTANTIATE_TEST_SUITE_P(AnglesFromGrazing, NearGrazing,
                         ::testing::Values(1.5, 1, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8));

TEST(TimeOfImpact, VerdictIsRightWithinUlpsOfAGraze) {
    testing::Random random(11);
    for (int i = 0; i < 20000; ++i) {
        const Vec2 along = normalized(random.direction());
        Vec2 c = random.uniform(0.1, 2) * along + kDiameter * Vec2{-along.y, along.x};
        const UniformMotion a{{}, random.uniform(0.1, 30) * along};
        for (std::size_t ulps = random.below(4); ulps > 0; --ulps)
            c.y = std::nextafter(c.y, random.below(2) == 0 ? kInfinity : -kInfinity);
        const UniformMotion b{c, {}};
        ASSERT_EQ(exact_toi(a, b, kDiameter).has_value(),
                  time_of_impact(a, b, kDiameter).has_value())
            << "geometry " << i;
    }
}

TEST(TimeOfImpact, ExactGrazeIsAHitAndAnUlpMoreIsAMiss) {
    for (const double speed : {1e-9, 1.0, 30.0}) {
        for (const double side : {1.0, -1.0}) {
            const Vec2 v{-speed, 0};
            const double graze = side * kDiameter;
            const double outside = std::nextafter(graze, side * kInfinity);
            const double inside = std::nextafter(graze, 0);
            EXPECT_NEAR(1, relative_toi({1, graze}, v).value() * speed, 1e-15);
            EXPECT_FALSE(relative_toi({1, outside}, v));
            EXPECT_TRUE(relative_toi({1, inside}, v));
            EXPECT_FALSE(relative_toi({1, graze * (1 + 1e-12)}, v));
            EXPECT_TRUE(relative_toi({1, graze * (1 - 1e-12)}, v));
        }
    }
}

TEST(TimeOfImpact, ObliqueExactGrazesAreHits) {
    // Pythagorean, so that c x v = |v| d holds without rounding: v = (3, 4), d = 5 / 64.
    const double d = 5.0 / 64;
    const Vec2 across{-4.0 / 64, 3.0 / 64};
    for (const double way : {0x1p-8, 0x1p-3, 1.0, 0x1p10}) {
        const Vec2 c{3 * way + across.x, 4 * way + across.y};
        const auto t = time_of_impact({{}, {3, 4}}, {c, {}}, d);
        ASSERT_TRUE(t) << way;
        EXPECT_NEAR(1, *t / way, 1e-14);
    }
}

TEST(TimeOfImpact, TouchingBallsMeetAtOnceOnlyIfTheyApproach) {
    EXPECT_EQ(0, relative_toi({kDiameter, 0}, {-1, 0}));
    EXPECT_EQ(0, relative_toi({kDiameter, 0}, {-5e-324, 0}));
    EXPECT_FALSE(relative_toi({kDiameter, 0}, {1, 0}));
    EXPECT_FALSE(relative_toi({kDiameter, 0}, {0, 1}));
    EXPECT_EQ(0, relative_toi({kDiameter / 2, 0}, {-1, 0}));
    EXPECT_FALSE(relative_toi({kDiameter / 2, 0}, {1, 0}));
}

TEST(TimeOfImpact, NoRelativeMotionIsNoContact) {
    EXPECT_FALSE(relative_toi({1, 0}, {0, 0}));
    EXPECT_FALSE(relative_toi({0, 0}, {0, 0}));
    EXPECT_FALSE(time_of_impact({{}, {3, 4}}, {{1, 1}, {3, 4}}, kDiameter));
    EXPECT_FALSE(relative_toi({0, 0}, {1, 0})) << "coincident balls do not approach";
}

TEST(TimeOfImpact, KeepsItsPrecisionFarFromTheOrigin) {
    const UniformMotion a{{1e6, -1e6}, {0, 1}};
    const UniformMotion b{{1e6, -1e6 + 1}, {0, 0}};
    EXPECT_NEAR(1, time_of_impact(a, b, kDiameter).value() / (1 - kDiameter), 1e-14);
}

TEST(TimeOfImpact, DoesNotDependOnTheOrderOfTheBallsOrOnTheHandOfTheFrame) {
    testing::Random random(3);
    for (int i = 0; i < 10000; ++i) {
        const auto [a, b] = geometry_at(random.uniform(1e-8, 1.5), i % 2 == 0, random);
        const auto mirrored = [](const UniformMotion& m) {
            return UniformMotion{{-m.r.x, m.r.y}, {-m.v.x, m.v.y}};
        };
        const auto t = time_of_impact(a, b, kDiameter);
        ASSERT_EQ(t, time_of_impact(b, a, kDiameter));
        ASSERT_EQ(t, time_of_impact(mirrored(a), mirrored(b), kDiameter));
    }
}

}  // namespace
}  // namespace poolhall
