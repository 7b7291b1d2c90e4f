#pragma once

#include "shared/game/settings.hpp"

namespace poolhall::test {

/// Settings as of real pool: cloth, throw between balls, rails by Han's model.
inline GameSettings pool_settings(SolverSpec solver = {SolverKind::kEvent, 30}) {
    Effects effects;
    effects.sliding = SlidingSpec{};
    effects.rolling = RollingSpec{};
    effects.spin_decay = SpinDecaySpec{};
    effects.ball_ball = {BallBallModel::kFriction, 0.95, 0.05, std::nullopt, 1e-4};
    effects.rail = {RailModel::kHan2005, 0.85, 0.2, 0.036576};
    return {effects, solver};
}

/// The solvers that may be played, and rates above and below that of the playout.
inline constexpr SolverSpec kPlayableSolvers[]{
    {SolverKind::kEuler, 30},      {SolverKind::kEuler, 120},   {SolverKind::kSemiImplicit, 20},
    {SolverKind::kExactArc, 1000}, {SolverKind::kExactArc, 30}, {SolverKind::kEvent, 30}};

}  // namespace poolhall::test
