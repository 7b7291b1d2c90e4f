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

void CollisionMarks::pass(const Playback::Passed& passed) {
    if (std::holds_alternative<Playback::ShotBegan>(passed)) marks_.clear();
    const auto* event = std::get_if<ShotEvent>(&passed);
    if (event == nullptr || !analysis::is_impact(*event)) return;
    for (std::size_t i = 0; i < event->ball_count; ++i)
        marks_.push_back({xy(event->after[i].r)});
}

}  // namespace poolhall::client
