#pragma once

#include "shared/physics/scene/scene.hpp"

#include <optional>

// The situations that were measured, each simulated by the event solver as any other scene.
namespace poolhall::lab {

/// Snooker balls as Mathavan, Jackson and Parkin measured them (Am. J. Phys. 77, 788, 2009).
inline constexpr BallSpec kSnookerBall{.radius = 0.02625, .mass = 0.1406};
/// Carom balls; the mass is not measured, and equal ones need none.
inline constexpr BallSpec kCaromBall{.radius = 0.03075, .mass = 0.21};
inline constexpr double kDegree = 3.14159265358979323846 / 180;  ///< rad

/// A cue ball meets a ball at rest, on a cloth without rails.
struct TwoBallCase {
    BallSpec ball = {};
    BallBallSpec impact = {};
    double speed = 1;    ///< of the cue ball at the impact, m/s
    double cut = 0;      ///< between its way and the line of centres, rad
    double follow = 1;   ///< spin about the horizontal axis, in that of a rolling ball
    double english = 0;  ///< spin about the vertical axis, in units of speed over radius
};

/// Speeds in m/s and directions in rad to the left of the cue ball's way before the impact; it
/// passes the object ball on its left.
struct TwoBallOutcome {
    double cue_speed = 0;
    double cue_angle = 0;
    double object_speed = 0;
    double object_angle = 0;  ///< negative: to the right
};

/// Just after the impact.
[[nodiscard]] TwoBallOutcome just_after(const TwoBallCase& one);
/// When both balls have ceased to slip.
[[nodiscard]] TwoBallOutcome after_slip(const TwoBallCase& one);
/// The same with the cut at which the object ball leaves by `object_angle` rad.
[[nodiscard]] TwoBallCase with_object_angle(TwoBallCase one, double object_angle);
/// How far the object ball leaves the line of centres, rad.
[[nodiscard]] double throw_of(const TwoBallCase& one);

/// A rolling ball without side meets a rail.
struct RailCase {
    BallSpec ball = {};
    RailSpec rail = {};
    double speed = 1;      ///< just before, m/s
    double incidence = 0;  ///< from the rail's normal, rad
    double mu_slide = 0.2;
};

struct RailOutcome {
    double speed = 0;  ///< m/s
    double angle = 0;  ///< from the rail's normal, rad
};

[[nodiscard]] RailOutcome just_after(const RailCase& one);
[[nodiscard]] RailOutcome after_slip(const RailCase& one);

}  // namespace poolhall::lab
