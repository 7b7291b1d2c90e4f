#pragma once

#include "shared/physics/arc.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

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

/// The boxes of all balls, an array a side: looking through them reads nothing else.
class Boxes {
  public:
    void resize(std::size_t balls) {
        low_x_.resize(balls);
        high_x_.resize(balls);
        low_y_.resize(balls);
        high_y_.resize(balls);
    }

    void set(std::size_t ball, const Box& box) {
        low_x_[ball] = box.low_x;
        high_x_[ball] = box.high_x;
        low_y_[ball] = box.low_y;
        high_y_[ball] = box.high_y;
    }

    /// Calls meet(other) for every ball from `from` on whose box overlaps that of `ball`, in order.
    template <class Meet>
    void for_each_overlap(std::size_t ball, std::size_t from, Meet meet) const {
        const double low_x = low_x_[ball];
        const double high_x = high_x_[ball];
        const double low_y = low_y_[ball];
        const double high_y = high_y_[ball];
        for (std::size_t i = from; i < low_x_.size(); ++i) {
            // No short cut: the comparisons cost less than branches that cannot be foreseen.
            const int overlaps =
                static_cast<int>(low_x_[i] <= high_x) & static_cast<int>(low_x <= high_x_[i]) &
                static_cast<int>(low_y_[i] <= high_y) & static_cast<int>(low_y <= high_y_[i]);
            if (overlaps != 0 && i != ball) meet(i);
        }
    }

  private:
    std::vector<double> low_x_;
    std::vector<double> high_x_;
    std::vector<double> low_y_;
    std::vector<double> high_y_;
};

}  // namespace poolhall
