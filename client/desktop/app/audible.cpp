#include "client/desktop/app/audible.hpp"

#include "shared/game/end_game.hpp"
#include "shared/table/pool_table.hpp"

#include <algorithm>
#include <cmath>

namespace poolhall::client {
namespace {

/// What sounds as loud as can be, m/s.
constexpr double kLoudest = end_game::kShotSpeed;

double loudness(double speed) {
    return std::clamp(std::abs(speed) / kLoudest, 0.0, 1.0);
}

double approach_speed(const ShotEvent& event) {
    const Vec2 along = normalized(xy(event.before[1].r) - xy(event.before[0].r));
    return dot(xy(event.before[0].v) - xy(event.before[1].v), along);
}

/// Of the rubber where a ball centred at `r` (m) touches a rail end.
Vec2 jaw_normal(const Table& table, Rail jaw, Vec2 r) {
    const PoolTable pool(table);
    const auto is_jaws = [jaw](const auto& part) { return part.rail == jaw; };
    const auto facing = std::find_if(pool.lines().begin(), pool.lines().end(), is_jaws);
    if (within(*facing, r)) return facing->normal;
    return normalized(std::find_if(pool.arcs().begin(), pool.arcs().end(), is_jaws)->centre - r);
}

double speed_into_rail(const ShotEvent& event, const Table& table) {
    const Vec2 v = xy(event.before[0].v);
    if (event.rail == Rail::kNorth || event.rail == Rail::kSouth) return v.y;
    if (event.rail < kFirstJaw) return v.x;
    return dot(v, jaw_normal(table, event.rail, xy(event.before[0].r)));
}

std::optional<Audible> audible_event(const ShotEvent& event, const Table& table) {
    const double pan = std::clamp(2 * event.after[0].r.x / table.length, -1.0, 1.0);
    switch (event.kind) {
        case EventKind::kStrike:
            return Audible{Sound::kCue, loudness(norm(xy(event.after[0].v))), pan};
        case EventKind::kBallBall:
            return Audible{Sound::kClick, loudness(approach_speed(event)), pan};
        case EventKind::kBallRail:
            return Audible{Sound::kRail, loudness(speed_into_rail(event, table)), pan};
        case EventKind::kBounce:
            return Audible{Sound::kRail, loudness(std::abs(event.before[0].v.z)), pan};
        case EventKind::kBallPocket:
            return Audible{Sound::kPocket, 1, pan};
        case EventKind::kRollToRest:
        case EventKind::kSlideToRoll:
        case EventKind::kSpinToRest:
        case EventKind::kOffTable:
            return std::nullopt;
    }
    return std::nullopt;
}

}  // namespace

std::optional<Audible> audible(const TableSound& sound, const Table& table) {
    if (const auto* event = std::get_if<ShotEvent>(&sound)) return audible_event(*event, table);
    const bool lost = std::get<GameEnded>(sound).tone == Tone::kLost;
    return Audible{lost ? Sound::kLost : Sound::kWon, 1, 0};
}

}  // namespace poolhall::client
