#include "shared/game/resting.hpp"

#include "shared/physics/motion/moving_ball.hpp"

#include <algorithm>

namespace poolhall {

namespace {

/// Parted balls may meet others, but ever fewer: two need one round, a rack that fits needs few.
constexpr int kMaxRounds = 100;

bool overlap(const Scene& scene, const SceneBall& a, const SceneBall& b) {
    return norm(xy(b.state.r) - xy(a.state.r)) <
           contact_distance(radius_of(scene, a), radius_of(scene, b)) - kTouchTolerance;
}

/// Moves `ball` straight away from `other` until they touch, or as far as the rails let it.
void move_off(const Scene& scene, SceneBall& ball, const SceneBall& other) {
    const Vec2 apart = xy(ball.state.r) - xy(other.state.r);
    const Vec2 away = apart == Vec2{} ? Vec2{1, 0} : normalized(apart);
    const Real distance = contact_distance(radius_of(scene, ball), radius_of(scene, other));
    Vec2 r = xy(other.state.r) + distance * away;
    if (scene.table.rails) {
        const Vec2 edge = inset(scene.table, radius_of(scene, ball));
        r = {std::clamp(r.x, -edge.x, edge.x), std::clamp(r.y, -edge.y, edge.y)};
    }
    set_xy(ball.state.r, r);
}

/// True if balls overlapped; they do no longer, unless others stood in the way.
bool part_pairs(Scene& scene) {
    bool found = false;
    for (std::size_t b = 1; b < scene.balls.size(); ++b) {
        for (std::size_t a = 0; a < b; ++a) {
            SceneBall& first = scene.balls[a];
            SceneBall& second = scene.balls[b];
            if (!overlap(scene, first, second)) continue;
            found = true;
            move_off(scene, second, first);
            // At a rail there was no room for it: then the other one gives way.
            if (overlap(scene, first, second)) move_off(scene, first, second);
        }
    }
    return found;
}

}  // namespace

void lay_at_rest(Scene& scene, const ShotTrace& trace) {
    for (std::size_t i = 0; i < trace.balls.size(); ++i) {
        BallState& state = scene.balls[i].state;
        state = trace.balls[i].state;
        // What rests already stays as it is to the bit, the sign of a zero included.
        if (state.r.z != 0) state.r.z = 0;
        if (state.v != Vec3{}) state.v = {};
        if (state.w != Vec3{}) state.w = {};
    }
}

void part_overlapping(Scene& scene) {
    for (int round = 0; round < kMaxRounds && part_pairs(scene); ++round) {
    }
}

}  // namespace poolhall
