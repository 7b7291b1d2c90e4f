#pragma once

#include "shared/physics/contact/contact_time.hpp"
#include "shared/physics/motion/arc.hpp"

#include <algorithm>

namespace poolhall {

/// What most searches for a meeting need of a ball on its arc, side by side.
struct Course {
    Vec2 r;  ///< at `since`, m
    Vec2 v;  ///< m/s; 0 where the centre rests
    Vec2 a;  ///< m/s^2
    Real since = 0;
    Real until = kNever;      ///< the ball's own event, s
    Real radius = 0;          ///< m
    bool moves = false;       ///< its centre does
    bool is_parabola = true;  ///< on the cloth, without drag

    /// In place: a copy of what was just written would have to wait for it.
    void set(const MovingBall& ball, const Arc& arc, Real end) {
        moves = moves_centre(ball.motion);
        r = ball.r;
        v = moves ? ball.v : Vec2{};
        a = moves ? arc.a : Vec2{};
        since = arc.since;
        until = end;
        radius = ball.radius;
        is_parabola = ball.motion != Motion::kAirborne && arc.drag == 0;
    }
};

/// False for most balls that do not meet from `now` (s) until either's own event; `a` sets out now.
[[nodiscard]] inline bool may_meet(const Course& a, const Course& b, Real now) {
    if (!a.moves && !b.moves) return false;
    if (!a.is_parabola || !b.is_parabola) return true;
    const Vec2 acceleration = b.a - a.a;
    if (acceleration == Vec2{}) return true;
    const Real dt = now - b.since;
    const Vec2 c = b.r + dt * (b.v + (dt / 2) * b.a) - a.r;
    const Vec2 v = b.v + dt * b.a - a.v;
    return !stay_apart(c, v, acceleration, contact_distance(a.radius, b.radius),
                       std::min(a.until, b.until) - now);
}

}  // namespace poolhall
