#include "shared/physics/contact/han_rail.hpp"
#include "shared/physics/contact/mathavan_rail.hpp"
#include "shared/physics/effects/presets.hpp"
#include "shared/table/presets.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace poolhall {
namespace {

/// How fast (m/s) a ball leaves that came in square at v, rolling.
double rebound(const RailSpec& spec, double radius, double mu_table, double v) {
    const RailContact rail{{0, 1},  radius,  0.14, spec.nose_height, restitution_of(spec, v),
                           spec.mu, mu_table};
    Vec3 velocity{0, v, 0};
    Vec3 spin{-v / radius, 0, 0};
    if (spec.model == RailModel::kHan2005)
        bounce_han2005(rail, velocity, spin);
    else
        bounce_mathavan2010(rail, velocity, spin);
    return -velocity.y;
}

/// Mathavan, Jackson, Parkin, Am. J. Phys. 77(9), 2009: the quadratic through 31 rebounds of a
/// snooker ball at 0.28 to 3.5 m/s.
double measured(double v) {
    return -0.0877 * v * v + 1.131 * v - 0.0953;
}

/// m/s, over 0.3 to 3.5 m/s.
double misfit(const RailSpec& spec, double radius, double mu_table) {
    double squares = 0;
    int count = 0;
    for (int i = 3; i <= 35; ++i, ++count) {
        const double error = rebound(spec, radius, mu_table, 0.1 * i) - measured(0.1 * i);
        squares += error * error;
    }
    return std::sqrt(squares / count);
}

TEST(RailRestitution, BySpeedGivesTheMeasuredReboundsOfASnookerBall) {
    constexpr double kRadius = 0.02625;
    RailSpec rail{.model = RailModel::kMathavan2010, .nose_height = 1.4 * kRadius};
    EXPECT_GT(misfit(rail, kRadius, 0.212), 0.1) << "a constant does not";
    rail.e_by_speed.emplace();
    const double by_default = misfit(rail, kRadius, 0.212);
    RecordProperty("rms_by_default_um_s", static_cast<int>(1e6 * by_default));
    EXPECT_LT(by_default, 0.02);
    EXPECT_LT(misfit(preset_value(EffectsPreset::kSnooker).rail, kRadius, 0.212), 0.006);
}

TEST(RailRestitution, OfThePoolPresetsGivesTheSame) {
    const double radius = preset_value(BallSet::kWpa).radius;
    EXPECT_LT(misfit(preset_value(EffectsPreset::kWorsted).rail, radius, 0.2), 0.006);
    EXPECT_LT(misfit(preset_value(EffectsPreset::kBar).rail, radius, 0.2), 0.006);
}

TEST(RailRestitution, SuitsHansRailToo) {
    const RailSpec rail{.model = RailModel::kHan2005,
                        .mu = 0.2,
                        .e_by_speed = RestitutionBySpeed{1, 1.044, 0.1172}};
    EXPECT_LT(misfit(rail, preset_value(BallSet::kWpa).radius, 0.2), 0.006);
}

TEST(RailRestitution, IsNeverNegativeAndNeverAboveItsLargest) {
    RailSpec rail;
    for (const double softening : {0.0, 0.1285, 0.5}) {
        rail.e_by_speed = RestitutionBySpeed{0.97, 1.1, softening};
        EXPECT_DOUBLE_EQ(0.97, restitution_of(rail, 1.1));
        for (double v = 1e-300; v < 1e6; v *= 1.7) {
            EXPECT_GE(restitution_of(rail, v), 0) << v;
            EXPECT_LE(restitution_of(rail, v), 0.97 + 1e-15) << v;
        }
    }
}

TEST(RailRestitution, LetsWhatComesInFasterLeaveFaster) {
    RailSpec rail;
    for (const double softening : {0.0, 0.1285, 0.3, 0.5}) {
        rail.e_by_speed = RestitutionBySpeed{1, 1.19, softening};
        double before = 0;
        for (double v = 1e-3; v < 1e3; v *= 1.01) {
            const double leaves = restitution_of(rail, v) * v;
            EXPECT_GT(leaves, before) << v << " " << softening;
            before = leaves;
        }
    }
}

TEST(RailRestitution, HangsOnTheSpeedAlongTheNormalOnly) {
    const RailSpec rail = preset_value(EffectsPreset::kWorsted).rail;
    const RailSpec constant{rail.model, restitution_of(rail, 1.5), rail.mu, rail.nose_height};
    const double radius = preset_value(BallSet::kWpa).radius;
    EXPECT_EQ(rebound(constant, radius, 0.2, 1.5), rebound(rail, radius, 0.2, 1.5));
}

}  // namespace
}  // namespace poolhall
