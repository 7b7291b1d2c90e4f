#include "shared/physics/contact/ball_friction.hpp"

#include "tests/shared/physics/friction_impacts.hpp"
#include "tests/shared/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace poolhall {
namespace {

using namespace testing;

constexpr double kDegree = std::numbers::pi / 180;
/// Alciatore's slow, medium and fast in TP A.14: 1, 3 and 7 mph.
constexpr double kSlow = 0.447;
constexpr double kMedium = 1.341;
constexpr double kFast = 3.129;

/// The angle (degrees) by which the object ball leaves the line of centres, against the cut, when a
/// cue ball with that speed along x and spins in units of v / R hits it at that cut angle.
double throw_angle(double speed, double cut, double follow, double side = 0) {
    const Vec3 n{std::cos(cut * kDegree), std::sin(cut * kDegree), 0};
    const double turn = speed / kRadius;
    ImpactBall cue = ball({speed, 0, 0}, {0, follow * turn, side * turn});
    ImpactBall object = ball();
    const double impulse = normal_impulse(1, n, cue, object);
    apply_friction(by_speed(), impulse, n, cue, object);
    apply_normal(impulse, n, cue, object);
    const double across = object.v.x * n.y - object.v.y * n.x;
    return std::atan2(across, dot(object.v, n)) / kDegree;
}

/// The place of the largest of f(0), f(step), f(2 step), ... f(steps step).
template <class F>
double place_of_maximum(F f, double step, int steps) {
    double best = 0;
    for (int i = 1; i <= steps; ++i) {
        const double x = step * i;
        if (f(x) > f(best)) best = x;
    }
    return best;
}

// Marlow, "The Physics of Pocket Billiards" (1995), table 10, as Alciatore uses it in TP A.14: 45
// degree cuts at 0.1, 1 and 10 m/s. The fit's constants have four digits.
TEST(BallFriction, FollowsMarlowsMeasurements) {
    const double sine = std::sqrt(0.5);
    EXPECT_NEAR(0.11, by_speed().coefficient(0.1 * sine), 1e-4);
    EXPECT_NEAR(0.06, by_speed().coefficient(1 * sine), 1e-4);
    EXPECT_NEAR(0.01, by_speed().coefficient(10 * sine), 1e-4);
}

TEST(BallFriction, IsConstantOrAbsentWhereTheSceneSaysSo) {
    EXPECT_EQ(0.05, constant(0.05).coefficient(0));
    EXPECT_EQ(0.05, constant(0.05).coefficient(7));
    for (const BallBallModel model : {BallBallModel::kElastic, BallBallModel::kRestitution}) {
        BallBallSpec spec;
        spec.model = model;
        EXPECT_EQ(0, BallFriction(spec).coefficient(1));
    }
}

// TP A.14: atan(min(mu(u) v cos(cut) / u, 1/7) (v sin(cut) - R w_z) / (v cos(cut))).
TEST(Throw, IsThatOfAlciatoresClosedForm) {
    testing::Random random(31);
    for (int i = 0; i < 2000; ++i) {
        const double v = random.uniform(0.05, 8);
        const double cut = random.uniform(0, 85);
        const double follow = random.uniform(-1, 1);
        const double side = random.uniform(-1.25, 1.25);
        const double cosine = std::cos(cut * kDegree);
        const double slip = v * (std::sin(cut * kDegree) - side);
        const double speed = std::hypot(slip, v * follow * cosine);
        const double mu = 9.951e-3 + 0.108 * std::exp(-1.088 * speed);
        const double share = std::min(mu * v * cosine / speed, 1.0 / 7);
        const double expected = std::atan(share * slip / (v * cosine)) / kDegree;
        EXPECT_NEAR(expected, throw_angle(v, cut, follow, side), 1e-11);
    }
}

// Alciatore, billiards.colostate.edu/tutorial/throw.html: most with slow stun shots "close to and
// larger than a 1/2-ball hit" (30 degrees); "about 1 inch per foot", about 5 degrees.
TEST(Throw, OfASlowStunShotIsLargestNearAHalfBallHit) {
    const auto at_cut = [](double cut) { return throw_angle(kSlow, cut, 0); };
    const double cut = place_of_maximum(at_cut, 0.1, 850);
    EXPECT_NEAR(30, cut, 5);
    EXPECT_NEAR(5, at_cut(cut), 0.5);
}

// The same page: "slow roll shots (about half of maximum throw)".
TEST(Throw, OfASlowRollingBallIsAboutHalfOfThat) {
    EXPECT_NEAR(0.5, throw_angle(kSlow, 30, 1) / throw_angle(kSlow, 30, 0), 0.1);
}

TEST(Throw, FallsWithSpeed) {
    for (const double cut : {35.0, 45.0, 60.0, 75.0}) {
        EXPECT_GT(throw_angle(kSlow, cut, 0), 1.2 * throw_angle(kMedium, cut, 0));
        EXPECT_GT(throw_angle(kMedium, cut, 0), 1.2 * throw_angle(kFast, cut, 0));
    }
}

// Alciatore, summary of billiards.colostate.edu/faq/throw: most with slow speed and about 50 % of
// the most english, which is a tip offset of R/2 and so a spin of 1.25 v/R.
TEST(Throw, BySpinAloneIsLargestAtHalfTheMostEnglish) {
    const auto at_english = [](double share) { return -throw_angle(kSlow, 0, 0, 1.25 * share); };
    const double share = place_of_maximum(at_english, 0.01, 100);
    EXPECT_NEAR(0.5, share, 0.05);
    EXPECT_NEAR(5, at_english(share), 0.5);
}

// Alciatore, billiards.colostate.edu/faq/sidespin/outside-gearing, the "40 % rule": for a half-ball
// hit 40 % of the most english, an offset of 0.2 R; sin(cut) times 0.4 R in general.
TEST(Throw, IsNoneWithGearingOutsideEnglish) {
    const double half_ball_spin = 2.5 * 0.2;
    EXPECT_NEAR(0, throw_angle(kSlow, 30, 0, half_ball_spin), 1e-13);
    EXPECT_GT(throw_angle(kSlow, 30, 0, half_ball_spin - 0.1), 0.5);
    EXPECT_LT(throw_angle(kSlow, 30, 0, half_ball_spin + 0.1), -0.5);
}

TEST(Throw, RightEnglishSendsTheObjectBallLeft) {
    ImpactBall cue = ball({1, 0, 0}, {0, 0, 20});
    ImpactBall object = ball();
    apply_friction(constant(0.05), kMass, {1, 0, 0}, cue, object);
    EXPECT_NEAR(0.05, object.v.y, 1e-15);
    EXPECT_LT(object.w.z, 0);
}

/// An impact as pooltool 0.6.0-dev resolves it (e = 0.95, mu = 0.05, object ball at rest): centres
/// at contact, then v and w.
struct PooltoolImpact {
    const char* shot;
    Vec3 cue_r, object_r;
    Vec3 cue_v, cue_w;
    Vec3 cue_v_after, cue_w_after;
    Vec3 object_v_after, object_w_after;
};

constexpr std::array<PooltoolImpact, 5> kPooltoolImpacts{{
    {"head-on follow",
     {50.0, 50.1928499999, 0},
     {50.0, 50.25, 0},
     {0, 1.487334135290386, 0},
     {-52.050188461605806, 0, 0},
     {0, 0.037183353382259685, 0},
     {-45.86922858179012, 0, 0},
     {0, 1.4501507819081263, 0},
     {6.18095987981569, 0, 0}},
    {"half-ball draw",
     {50.0, 50.200506648058244, 0},
     {50.028575, 50.25, 0},
     {0, 1.2096329660547178, 0},
     {53.33621750259998, 0, 0},
     {-0.4927401140460148, 0.31472446097258533, 0},
     {49.90874538515227, 1.978851945031188, -1.8135428942814715},
     {0.49274011404601487, 0.8949085050821325, 0},
     {-3.4274721174477145, 1.978851945031185, -1.8135428942814715}},
    {"thin follow",
     {50.0, 50.23399799964287, 0},
     {50.054864, 50.25, 0},
     {0, 1.4846176586582818, 0},
     {-51.95512366258204, 0, 0},
     {-0.38378103557978416, 1.3529361055163696, 0},
     {-51.81968703786133, -0.46435413153611727, -1.6584075785184287},
     {0.38378103557978416, 0.13168155314191235, 0},
     {0.13543662472071064, -0.4643541315361221, -1.6584075785184287}},
    {"half-ball with left english",
     {50.0, 50.200506648058244, 0},
     {50.028575, 50.25, 0},
     {0, 1.2096329660547178, 0},
     {-25.40393997771498, 0, -38.3868498114151},
     {-0.5372534884005536, 0.3404242695787524, 0},
     {-22.43511078877387, -1.714054327413825, -35.70348830479709},
     {0.5372534884005538, 0.8692086964759654, 0},
     {2.968829188941112, -1.7140543274138234, 2.683361506618004}},
    {"rolling, almost head-on",
     {0.638, 1.7429287943755347, 0},
     {0.635, 1.8, 0},
     {0, 1.0657291377332558, 0},
     {-37.29585783843415, 0, 0},
     {0.051819981415718495, 0.029367193051160083, 0},
     {-32.88526819020795, 0.23184666943511223, 0.2321667649460202},
     {-0.05181998141571849, 1.0363619446820955, 0},
     {4.410589648226203, 0.23184666943511034, 0.2321667649460202}},
}};

/// pooltool gives its centres at x = 50 m to 7e-15 m, and so the normal to 1e-13.
void expect_close(Vec3 expected, Vec3 actual, double scale) {
    EXPECT_NEAR(0, norm(expected - actual), 1e-12 * scale);
}

// It is the vertical impulse that shows that pooltool, too, leaves it to the slate. Its friction
// goes with e times the closing speed instead of (1 + e)/2, so that is what it is given here.
TEST(BallFriction, AgreesWithPooltool) {
    for (const PooltoolImpact& impact : kPooltoolImpacts) {
        SCOPED_TRACE(impact.shot);
        const Vec3 apart = impact.object_r - impact.cue_r;
        const Vec3 n = 1 / norm(apart) * apart;
        ImpactBall cue = ball(impact.cue_v, impact.cue_w);
        ImpactBall object = ball();
        const double normal = normal_impulse(0.95, n, cue, object);
        apply_friction(constant(0.05), normal * 0.95 / 0.975, n, cue, object);
        apply_normal(normal, n, cue, object);
        expect_close(impact.cue_v_after, cue.v, 1);
        expect_close(impact.object_v_after, object.v, 1);
        expect_close(impact.cue_w_after, cue.w, 1 / kRadius);
        expect_close(impact.object_w_after, object.w, 1 / kRadius);
    }
}

TEST(BallFriction, NothingSlipsNothingChanges) {
    ImpactBall cue = ball({1, 0, 0}, {3, 0, 0});
    ImpactBall object = ball({0, 0, 0}, {-7, 0, 0});
    apply_friction(by_speed(), 1, {1, 0, 0}, cue, object);
    EXPECT_EQ((Vec3{1, 0, 0}), cue.v);
    EXPECT_EQ((Vec3{3, 0, 0}), cue.w);
    EXPECT_EQ((Vec3{}), object.v);
    EXPECT_EQ((Vec3{-7, 0, 0}), object.w);
}

TEST(BallFriction, SlipsTooSmallToSquareEndAsWell) {
    for (const double slip : {1e-170, 1e-300, 5e-324}) {
        ImpactBall cue = ball({0, slip, 0});
        ImpactBall object = ball();
        apply_friction(by_speed(), 1e-3, {1, 0, 0}, cue, object);
        EXPECT_TRUE(std::isfinite(cue.w.z) && std::isfinite(object.w.z));
        EXPECT_LE(norm(object.v), slip / 7);
    }
}

}  // namespace
}  // namespace poolhall
