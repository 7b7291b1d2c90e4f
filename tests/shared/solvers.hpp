#pragma once

#include "shared/physics/simulate.hpp"

#include <array>
#include <gtest/gtest.h>
#include <string>

namespace poolhall::testing {

/// All but `overlap`, which misses contacts by design.
inline constexpr std::array kSweptSolvers{SolverKind::kEuler, SolverKind::kSemiImplicit,
                                          SolverKind::kExactArc, SolverKind::kEvent};
inline constexpr std::array kAllSolvers = kValues<SolverKind>;
/// Closed-form motion between events.
inline constexpr std::array kClosedFormSolvers{SolverKind::kExactArc, SolverKind::kEvent};

inline std::string solver_name(const ::testing::TestParamInfo<SolverKind>& test) {
    return std::string(name(test.param));
}

/// Sliding, rolling and restitution, as in the reference shots.
inline Effects cloth_effects() {
    Effects effects;
    effects.sliding = SlidingSpec{0.2};
    effects.rolling = RollingSpec{0.01};
    effects.ball_ball.model = BallBallModel::kRestitution;
    effects.rail.model = RailModel::kRestitution;
    effects.rail.e = 0.85;
    return effects;
}

/// The cloth, spin that decays, throw between balls and Han's rails.
inline Effects pool_effects() {
    Effects effects = cloth_effects();
    effects.spin_decay = SpinDecaySpec{};
    effects.ball_ball.model = BallBallModel::kFriction;
    effects.rail.model = RailModel::kHan2005;
    return effects;
}

}  // namespace poolhall::testing
