#pragma once

#include "shared/physics/scene/scene.hpp"

#include <cstddef>
#include <vector>

// What `poolhall-lab bench` simulates. All on real cloth, balls and rails (cloth_effects()), by the
// event solver unless said otherwise.
namespace poolhall::lab {

/// Turns the strike of ball 0 so that its line passes `aside` contact distances, or a little less,
/// to the left of ball 1.
void aim_at_object(Scene& scene, double aside);

/// Shots at an object ball, anywhere on the table, full to thin, 1 to 5 m/s.
[[nodiscard]] std::vector<Scene> two_ball_shots(std::size_t count);

/// The cue ball into a diamond of nine, a tenth of a millimetre apart, at 8 m/s.
[[nodiscard]] Scene nine_ball_break();

/// The cue ball into a triangle of fifteen whose neighbours are `gap` m apart, at 8 m/s.
[[nodiscard]] Scene fifteen_ball_break(double gap);

/// `count` balls that all move, on a table whose area is in proportion.
[[nodiscard]] Scene crowd(std::size_t count);

/// A ball that rolls `gap` m behind another of speed 1 m/s, faster by `surplus` m/s.
[[nodiscard]] Scene slow_chase(double gap, double surplus);

/// A ball that passes another, `way` m off, within `ulps` units in the last place of a graze, along
/// +x, -x, +y or -y (quarter 0 to 3), on a frictionless endless cloth. Less than 0 hits, more than
/// 0 misses.
[[nodiscard]] Scene graze(int ulps, int quarter, double way);

}  // namespace poolhall::lab
