#include "server/room/playout.hpp"

#include "shared/analysis/effect_use.hpp"
#include "shared/physics/simulate.hpp"

#include <algorithm>
#include <cassert>
#include <string>
#include <utility>

namespace poolhall::server {

using protocol::Frame;
using Microseconds = std::chrono::duration<double, std::micro>;

Playout::Playout(MatchStep step, std::chrono::nanoseconds cpu) : step_(std::move(step)), cpu_(cpu) {
    assert(step_.shot() && trace().sample_hz == kPlayoutHz);
}

std::uint32_t Playout::last_tick() const {
    return static_cast<std::uint32_t>(std::max<std::size_t>(trace().sample_count(), 2) - 1);
}

Vec2 Playout::place(std::size_t ball, std::uint32_t tick) const {
    const std::size_t last = trace().sample_count() - 1;
    return xy(trace().sample(std::min<std::size_t>(tick, last), ball));
}

Frame Playout::advance(std::uint32_t tick) {
    assert(tick > tick_ && tick <= last_tick());
    const ShotTrace& shown = trace();
    Frame frame{shot().shot, tick, {}, {}};
    for (std::size_t ball = 0; ball < shown.balls.size(); ++ball) {
        const Vec2 r = place(ball, tick);
        if (r != place(ball, tick_))
            frame.balls.push_back({BallIndex{static_cast<std::uint16_t>(ball)}, r});
    }
    const double until = static_cast<double>(tick) / shown.sample_hz;
    while (next_event_ < shown.events.size() &&
           (tick == last_tick() || shown.events[next_event_].t <= until))
        frame.events.push_back(shown.events[next_event_++]);
    tick_ = tick;
    return frame;
}

protocol::LiveShot Playout::live() const {
    protocol::LiveShot live{shot().shot, tick_, {}};
    for (std::size_t ball = 0; ball < trace().balls.size(); ++ball)
        live.balls.push_back(place(ball, tick_));
    return live;
}

protocol::ShotStarted Playout::started(protocol::Stream stream) const {
    const Scene& scene = shot().simulated.scene;
    protocol::ShotStarted started{shot().shot, step_.made.seat, scene, hash_of(scene), {}};
    if (stream == protocol::Stream::kShots) started.final_hash = trace().hash;
    return started;
}

protocol::ShotEnded Playout::ended() const {
    const ShotTrace& shown = trace();
    return {shot().shot,
            last_tick(),
            shown.duration,
            shown.outcome,
            std::string(shown.kernel),
            analysis::effect_uses(shot().simulated.scene, shown),
            shown.solver,
            Microseconds(cpu_).count(),
            shown.balls,
            shown.hash,
            *step_.ruling(),
            {}};
}

}  // namespace poolhall::server
