#include "client/desktop/view/ball_spin.hpp"

#include <cmath>

namespace poolhall::client {
namespace {

Orientation product(const Orientation& a, const Orientation& b) {
    return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
            a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

Orientation unit(const Orientation& q) {
    const double length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    return {q.w / length, q.x / length, q.y / length, q.z / length};
}

}  // namespace

Orientation turned(const Orientation& from, const Vec3& axis, double angle) {
    const double s = std::sin(angle / 2);
    return unit(product({std::cos(angle / 2), s * axis.x, s * axis.y, s * axis.z}, from));
}

Vec3 to_ball(const Orientation& orientation, const Vec3& world) {
    const Orientation inverse{orientation.w, -orientation.x, -orientation.y, -orientation.z};
    const Orientation vector{0, world.x, world.y, world.z};
    const Orientation turned_back = product(product(inverse, vector), orientation);
    return {turned_back.x, turned_back.y, turned_back.z};
}

const Orientation& BallSpin::follow(const std::string& id, Vec2 r, double radius, double jump) {
    Tracked& ball = balls_.try_emplace(id, Tracked{r, {}}).first->second;
    const Vec2 moved = r - ball.r;
    const double distance = norm(moved);
    ball.r = r;
    if (!(distance <= jump)) {
        ball.orientation = {};
    } else if (distance > 0) {
        // Rolling without slip: w = z x v / R.
        ball.orientation = turned(ball.orientation, {-moved.y / distance, moved.x / distance, 0},
                                  distance / radius);
    }
    return ball.orientation;
}

}  // namespace poolhall::client
