#include "shared/physics/effects/presets.hpp"

#include <array>

namespace poolhall {

namespace {

struct Row {
    Real sliding;
    Real rolling;
    Real spin_decay;
    RailSpec rail;
};

constexpr RestitutionBySpeed kPoolNose{0.975, 1.051, 0.134};
constexpr RailSpec kPoolRail{RailModel::kMathavan2010, 0.98, 0.14, 0.03629025, kPoolNose};
constexpr RailSpec kSnookerRail{RailModel::kMathavan2010, 0.98, 0.1, 0.03675,
                                RestitutionBySpeed{0.995, 1.048, 0.126}};
constexpr RailSpec kCaromRail{RailModel::kMathavan2010, 0.98, 0.17, 0.037,
                              RestitutionBySpeed{0.858, 0.6, 0.0155}};

constexpr std::array<Row, kCount<EffectsPreset>> kRows{{
    {0.2, 0.01, 0.0127, kPoolRail},
    {0.2, 0.007, 0.0127, kPoolRail},
    {0.212, 0.0127, 0.0117, kSnookerRail},
    {0.2, 0.0043, 0.0063, kCaromRail},
}};

}  // namespace

Effects preset_value(EffectsPreset preset) {
    const Row& row = kRows[static_cast<std::size_t>(preset)];
    Effects effects;
    effects.sliding = SlidingSpec{row.sliding};
    effects.rolling = RollingSpec{row.rolling};
    effects.spin_decay = SpinDecaySpec{row.spin_decay};
    effects.airborne = AirborneSpec{};
    effects.ball_ball = BallBallSpec{};
    effects.ball_ball.friction_by_speed.emplace();
    effects.rail = row.rail;
    return effects;
}

}  // namespace poolhall
