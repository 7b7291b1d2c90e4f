#pragma once

#include "client/lab/recorded/recording.hpp"
#include "shared/physics/contact/rail_spec.hpp"
#include "shared/physics/scene/scene.hpp"

#include <string>
#include <vector>

namespace poolhall::lab {

/// What is the same in all shots of a table.
struct TableConstants {
    double mu_slide = 0.2;
    double mu_roll = 0.0043;  ///< a heated carom cloth
    double mu_spin = 0.0127;
    BallBallSpec ball_ball;
    RailSpec rail;
};

/// One of them that is fitted.
struct FittedConstant {
    std::string name;
    double* (*place)(TableConstants& constants);
    double low = 0;
    double high = 0;
    double step = 0;  ///< how far a search first looks
};

/// Those that matter under that model of the rail.
[[nodiscard]] std::vector<FittedConstant> fitted_constants(const RailSpec& rail);

/// The shot's balls at rest where it begins, the cue ball to be struck.
[[nodiscard]] Scene scene_of(const RecordedShot& shot, const TableConstants& constants);

}  // namespace poolhall::lab
