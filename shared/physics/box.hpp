#pragma once

#include "shared/physics/arc.hpp"

#include <algorithm>
#include <limits>

namespace poolhall {

/// An axis-parallel box in the plane, m.
struct Box {
    double low_x = 0;
    double high_x = 0;
    double low_y = 0;
    double high_y = 0;

    /// Two discs, a little generously: more than rounding.
    static Box around(Vec2 r, Vec2 other, double radius) {
        const double reach = kMargin * radius;
        return {std::min(r.x, other.x) - reach, std::max(r.x, other.x) + reach,
                std::min(r.y, other.y) - reach, std::max(r.y, other.y) + reach};
    }

    static constexpr Box everything() { return {-kFar, kFar, -kFar, kFar}; }

    /// Widens by where x + v t + a t^2 / 2 turns within `time`: v^2 / (2 |a|) beyond its start.
    void add_turn_x(double v, double a, double time) {
        if (v * (v + a * time) < 0) widen(low_x, high_x, -v * v / (2 * a));
    }

    void add_turn_y(double v, double a, double time) {
        if (v * (v + a * time) < 0) widen(low_y, high_y, -v * v / (2 * a));
    }

  private:
    static constexpr double kFar = std::numeric_limits<double>::infinity();
    static constexpr double kMargin = 1 + 0x1p-20;  ///< of the radius

    static void widen(double& low, double& high, double way) {
        if (way < 0) {
            low += way;
        } else {
            high += way;
        }
    }
};

/// Where the ball's surface gets on its arc up to `end` (s).
[[nodiscard]] inline Box box_around(const MovingBall& ball, const Arc& arc, double end) {
    if (!moves_centre(ball.motion)) return Box::around(ball.r, ball.r, ball.radius);
    if (end == kNever) return Box::everything();
    Box box = Box::around(ball.r, place_on(ball, arc, end), ball.radius);
    if (ball.motion != Motion::kSliding) return box;
    // A parabola turns once along each axis.
    const double time = end - arc.since;
    box.add_turn_x(ball.v.x, arc.a.x, time);
    box.add_turn_y(ball.v.y, arc.a.y, time);
    return box;
}

}  // namespace poolhall
