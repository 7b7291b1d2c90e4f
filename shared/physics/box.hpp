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

    /// A disc, a little generously: more than rounding.
    static Box around(Vec2 r, double radius) {
        Box box{r.x, r.x, r.y, r.y};
        box.add(r, radius);
        return box;
    }

    static constexpr Box everything() { return {-kFar, kFar, -kFar, kFar}; }

    static constexpr Box nothing() { return {kFar, -kFar, kFar, -kFar}; }

    void add(Vec2 r, double radius) {
        add_x(r.x, radius);
        add_y(r.y, radius);
    }

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

    void add_x(double x, double radius) {
        low_x = std::min(low_x, x - kMargin * radius);
        high_x = std::max(high_x, x + kMargin * radius);
    }

    void add_y(double y, double radius) {
        low_y = std::min(low_y, y - kMargin * radius);
        high_y = std::max(high_y, y + kMargin * radius);
    }

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
    Box box = Box::around(ball.r, ball.radius);
    if (!moves_centre(ball.motion)) return box;
    if (end == kNever) return Box::everything();
    box.add(place_on(ball, arc, end), ball.radius);
    if (ball.motion != Motion::kSliding) return box;
    // A parabola turns once along each axis.
    const double time = end - arc.since;
    box.add_turn_x(ball.v.x, arc.a.x, time);
    box.add_turn_y(ball.v.y, arc.a.y, time);
    return box;
}

[[nodiscard]] constexpr bool overlap(const Box& a, const Box& b) {
    return a.low_x <= b.high_x && b.low_x <= a.high_x && a.low_y <= b.high_y && b.low_y <= a.high_y;
}

}  // namespace poolhall
