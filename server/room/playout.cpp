#include "server/room/playout.hpp"

#include "shared/physics/simulate.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace poolhall::server {

using protocol::Frame;

Playout::Playout(std::uint32_t shot, ShotOutcome outcome, std::chrono::nanoseconds cpu)
    : shot_(shot), outcome_(std::move(outcome)), cpu_(cpu) {
    assert(outcome_.trace.sample_hz == kPlayoutHz);
}

std::uint32_t Playout::last_tick() const {
    return static_cast<std::uint32_t>(std::max<std::size_t>(outcome_.trace.sample_count(), 2) - 1);
}

Vec2 Playout::place(std::size_t ball, std::uint32_t tick) const {
    const std::size_t last = outcome_.trace.sample_count() - 1;
    return xy(outcome_.trace.sample(std::min<std::size_t>(tick, last), ball));
}

Frame Playout::advance(std::uint32_t tick) {
    assert(tick > tick_ && tick <= last_tick());
    const ShotTrace& trace = outcome_.trace;
    Frame frame{shot_, tick, {}, {}};
    for (std::size_t ball = 0; ball < trace.balls.size(); ++ball) {
        const Vec2 r = place(ball, tick);
        if (r != place(ball, tick_))
            frame.balls.push_back({BallIndex{static_cast<std::uint16_t>(ball)}, r});
    }
    const double until = static_cast<double>(tick) / trace.sample_hz;
    while (next_event_ < trace.events.size() &&
           (tick == last_tick() || trace.events[next_event_].t <= until))
        frame.events.push_back(trace.events[next_event_++]);
    tick_ = tick;
    return frame;
}

protocol::LiveShot Playout::live() const {
    protocol::LiveShot live{shot_, tick_, {}};
    for (std::size_t ball = 0; ball < outcome_.trace.balls.size(); ++ball)
        live.balls.push_back(place(ball, tick_));
    return live;
}

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
