#pragma once

#include "shared/math/vec3.hpp"

#include <string>
#include <unordered_map>

namespace poolhall::client {

/// A rotation as a unit quaternion.
struct Orientation {
    double w = 1;
    double x = 0;
    double y = 0;
    double z = 0;

    friend bool operator==(const Orientation&, const Orientation&) = default;
};

/// The orientation after a further turn about a unit axis (of the table, not of the ball),
/// right-handed, rad.
[[nodiscard]] Orientation turned(const Orientation& from, const Vec3& axis, double angle);
/// The world's direction as the ball sees it.
[[nodiscard]] Vec3 to_ball(const Orientation& orientation, const Vec3& world);

/// How each ball lies, found from how far it has moved from picture to picture: all of them roll.
class BallSpin {
  public:
    /// The ball's orientation, now that its centre is at `r` (m). A jump of more than `jump` metres
    /// is no rolling: the ball was set down anew.
    const Orientation& follow(const std::string& id, Vec2 r, double radius, double jump);

  private:
    struct Tracked {
        Vec2 r;
        Orientation orientation;
    };

    std::unordered_map<std::string, Tracked> balls_;
};

}  // namespace poolhall::client
