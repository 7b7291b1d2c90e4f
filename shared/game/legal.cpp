#include "shared/game/legal.hpp"

#include <algorithm>
#include <cmath>

namespace poolhall {

namespace {

/// How far outside the region a place may be, m: a client's arithmetic may round differently.
constexpr Real kPlaceTolerance = 1e-6;

using MaybeFault = std::optional<IllegalMove>;

bool within(Real x, Real low, Real high) {
    return x >= low && x <= high;
}

MaybeFault fault(std::string_view field, Illegal code) {
    return IllegalMove{code, field};
}

MaybeFault check_stroke(const StrokeBounds& bounds, const Stroke& stroke) {
    const auto [x, y] = stroke.direction;
    if (!std::isfinite(x) || !std::isfinite(y) || (x == 0 && y == 0))
        return fault("/strike/direction", Illegal::kBadDirection);
    if (stroke.speed && !within(*stroke.speed, bounds.min_speed, bounds.max_speed))
        return fault("/strike/speed", Illegal::kOutOfBounds);
    const Real square = dot(stroke.offset, stroke.offset);
    if (!within(square, 0, bounds.max_offset * bounds.max_offset))
        return fault("/strike/offset", Illegal::kOutOfBounds);
    if (!within(stroke.elevation, 0, bounds.max_elevation))
        return fault("/strike/elevation", Illegal::kOutOfBounds);
    return std::nullopt;
}

struct FaultFinder {
    const Legal& legal;

    MaybeFault operator()(const Shoot& move) const {
        if (!legal.shoot) return fault("", Illegal::kNotOffered);
        return check_stroke(*legal.shoot, move.strike);
    }

    MaybeFault operator()(const Place& move) const {
        if (!legal.place) return fault("", Illegal::kNotOffered);
        const Vec2 off = nearest_place(*legal.place, move.position) - move.position;
        if (std::abs(off.x) <= kPlaceTolerance && std::abs(off.y) <= kPlaceTolerance)
            return std::nullopt;
        return fault("/position", Illegal::kOutOfRegion);
    }

    /// Whether they may be made is a matter of the match.
    MaybeFault operator()(const Concede&) const { return std::nullopt; }

    MaybeFault operator()(const Agree&) const { return std::nullopt; }

    MaybeFault operator()(const TimeOut&) const { return std::nullopt; }
};

}  // namespace

Vec2 nearest_place(const Region& region, Vec2 position) {
    return {std::clamp(position.x, region.low.x, region.high.x),
            std::clamp(position.y, region.low.y, region.high.y)};
}

std::optional<IllegalMove> find_fault(const Legal& legal, const Move& move) {
    return std::visit(FaultFinder{legal}, move);
}

Move completed(const Legal& legal, Move move) {
    if (auto* shoot = std::get_if<Shoot>(&move); shoot && legal.shoot && !shoot->strike.speed)
        shoot->strike.speed = legal.shoot->own_speed;
    if (auto* place = std::get_if<Place>(&move); place && legal.place)
        place->position = nearest_place(*legal.place, place->position);
    return move;
}

}  // namespace poolhall
