#pragma once

#include "shared/math/vec2.hpp"
#include "shared/physics/scene/scene.hpp"
#include "shared/result.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

// Shots of three-cushion billiards that a camera has recorded: where each ball was, and when.
namespace poolhall::lab {

/// The table and the balls that such recordings are of: 2.84 m by 1.42 m, 61.5 mm. A ball's mass is
/// not measured, and equal ones need none.
inline constexpr double kCaromLength = 2.84;
inline constexpr double kCaromWidth = 1.42;
inline constexpr BallSpec kRecordedBall{.radius = 0.03075, .mass = 0.21};

/// Places of one ball, from the table's centre; between them it was about where the straight line
/// leads. The last stands until the end.
struct RecordedTrack {
    std::vector<double> t;  ///< s, ascending
    std::vector<Vec2> r;    ///< m
};

struct RecordedShot {
    std::string id;
    std::vector<RecordedTrack> tracks;
    std::size_t cue = 0;  ///< the ball that moves first
};

/// A JSON array of {"id", "balls": {NAME: {"t": [], "x": [], "y": []}}}. The fault says where: the
/// line of a syntax error, or the JSON pointer.
[[nodiscard]] Result<std::vector<RecordedShot>, std::string> parse_recording(std::string_view text);

/// The same of a file; the fault begins with its name.
[[nodiscard]] Result<std::vector<RecordedShot>, std::string> read_recording(
    const std::string& file);

}  // namespace poolhall::lab
