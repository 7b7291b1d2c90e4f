#include "client/play/overlays.hpp"

#include "shared/analysis/agreement.hpp"

#include <algorithm>

namespace poolhall::client {
namespace {

constexpr double kLeastMove = 1e-5;  // m; what is sent over the network is rounded to this

}  // namespace

void StepTrail::step(std::span<const Vec2> before, std::span<const Vec2> after) {
    for (TrailRing& ring : rings_)
        ring.strength -= 1.0 / kLife;
    std::erase_if(rings_, [](const TrailRing& ring) { return ring.strength <= 0; });
    for (std::size_t i = 0; i < std::min(before.size(), after.size()); ++i) {
        if (norm(after[i] - before[i]) < kLeastMove) continue;
        rings_.push_back({before[i], BallIndex{static_cast<std::uint16_t>(i)}, 1});
    }
}

std::vector<CollisionMark> collision_marks(const ShotTimeline& timeline, double t) {
    std::vector<CollisionMark> marks;
    for (const ShotEvent& event : timeline.events().first(timeline.events_until(t))) {
        if (!analysis::is_impact(event)) continue;
        for (std::size_t i = 0; i < event.ball_count; ++i)
            marks.push_back({xy(event.after[i].r)});
    }
    return marks;
}

}  // namespace poolhall::client
