#pragma once

#include "shared/physics/motion/arc.hpp"

#include <algorithm>

namespace poolhall {

/// An axis-parallel box in the plane, m.
struct Box {
    Real low_x = 0;
    Real high_x = 0;
    Real low_y = 0;
    Real high_y = 0;

    /// Two discs, a little generously: more than rounding.
    static Box around(Vec2 r, Vec2 other, Real radius) {
        const Real reach = kMargin * radius;
        return {std::min(r.x, other.x) - reach, std::max(r.x, other.x) + reach,
                std::min(r.y, other.y) - reach, std::max(r.y, other.y) + reach};
    }

    static constexpr Box everything() { return {-kFar, kFar, -kFar, kFar}; }

    /// Holds no point.
    static constexpr Box nothing() { return {kFar, -kFar, kFar, -kFar}; }

    /// Widens by where x + v t + a t^2 / 2 turns within `time`: v^2 / (2 |a|) beyond its start.
    void add_turn_x(Real v, Real a, Real time) {
        if (v * (v + a * time) < 0) widen(low_x, high_x, -v * v / (2 * a));
    }

    void add_turn_y(Real v, Real a, Real time) {
        if (v * (v + a * time) < 0) widen(low_y, high_y, -v * v / (2 * a));
    }

  private:
    static constexpr Real kFar = kInfinity;
    static constexpr Real kMargin = 1 + 0x1p-20;  ///< of the radius

    static void widen(Real& low, Real& high, Real way) {
        if (way < 0) {
            low += way;
        } else {
            high += way;
        }
    }
};

/// The smallest box that holds both.
[[nodiscard]] constexpr Box united(const Box& a, const Box& b) {
    return {std::min(a.low_x, b.low_x), std::max(a.high_x, b.high_x), std::min(a.low_y, b.low_y),
            std::max(a.high_y, b.high_y)};
}

/// True for boxes that have no point in common; false where a side is no number.
[[nodiscard]] constexpr bool are_apart(const Box& a, const Box& b) {
    return a.high_x < b.low_x || b.high_x < a.low_x || a.high_y < b.low_y || b.high_y < a.low_y;
}

/// True if no point of the box is in the disc; false for some others that are near a corner.
[[nodiscard]] constexpr bool is_clear_of(const Box& box, Vec2 centre, Real radius) {
    return are_apart(box,
                     {centre.x - radius, centre.x + radius, centre.y - radius, centre.y + radius});
}

/// Where the ball's surface gets on its arc up to `end` (s).
[[nodiscard]] inline Box box_around(const MovingBall& ball, const Arc& arc, Real end) {
    if (!moves_centre(ball.motion)) return Box::around(ball.r, ball.r, ball.radius);
    if (end == kNever) return Box::everything();
    Box box = Box::around(ball.r, place_on(ball, arc, end), ball.radius);
    if (ball.motion != Motion::kSliding) return box;
    // A parabola turns once along each axis.
    const Real time = end - arc.since;
    box.add_turn_x(ball.v.x, arc.a.x, time);
    box.add_turn_y(ball.v.y, arc.a.y, time);
    return box;
}

/// Where the centre of a ball gets whose surface stays within the box: still wider than rounding.
[[nodiscard]] constexpr Box centres_of(const Box& surface, Real radius) {
    return {surface.low_x + radius, surface.high_x - radius, surface.low_y + radius,
            surface.high_y - radius};
}

}  // namespace poolhall
