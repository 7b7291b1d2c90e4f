#include "server/delivery/merge_frames.hpp"

#include <algorithm>
#include <cassert>

namespace poolhall::server {

using protocol::Frame;

Frame merge(const Frame& older, const Frame& newer) {
    assert(older.shot == newer.shot && older.tick < newer.tick);
    Frame merged = newer;
    for (const Frame::Ball& ball : older.balls) {
        const auto moved = [&](const Frame::Ball& other) { return other.ball == ball.ball; };
        if (std::none_of(newer.balls.begin(), newer.balls.end(), moved))
            merged.balls.push_back(ball);
    }
    merged.events.insert(merged.events.begin(), older.events.begin(), older.events.end());
    return merged;
}

}  // namespace poolhall::server
