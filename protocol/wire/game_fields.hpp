#pragma once

#include "protocol/wire/scene_fields.hpp"
#include "protocol/wire/tagged.hpp"
#include "shared/game/legal.hpp"
#include "shared/game/move.hpp"

#include <tuple>

// Moves, states and rulings of a game, the same in messages and in replays.
namespace poolhall::protocol::wire {

template <>
inline constexpr auto kFields<Stroke> = std::tuple{
    field("direction", &Stroke::direction, Direction{}),
    field("speed", &Stroke::speed, Number{0, kAnyMagnitude}),
    field("offset", &Stroke::offset, Vector2{1}).or_default(),
    field("elevation", &Stroke::elevation, Number{0, kAnyMagnitude}).or_default(),
};

template <>
inline constexpr auto kFields<Shoot> = std::tuple{field("strike", &Shoot::strike)};

template <>
inline constexpr auto kFields<Place> = std::tuple{field("position", &Place::position, Vector2{})};

template <>
inline constexpr auto kFields<Concede> = std::tuple{};

template <>
inline constexpr auto kFields<Agree> = std::tuple{field("what", &Agree::what)};

template <>
inline constexpr auto kFields<TimeOut> = std::tuple{};

template <>
struct DefaultCodec<Scene> : SceneCodec {};

template <>
struct DefaultCodec<GamePart> : Tagged {};

/// A whole state, whose parts agree with one another.
struct GameStateCodec {
    [[nodiscard]] bool read(const Cursor& cursor, GameState& state) const;
    [[nodiscard]] Json write(const GameState& state, Encoding encoding) const;
};

template <>
inline constexpr auto kFields<Region> = std::tuple{
    field("low", &Region::low, Vector2{}),
    field("high", &Region::high, Vector2{}),
};

template <>
inline constexpr auto kFields<StrokeBounds> = std::tuple{
    field("min_speed", &StrokeBounds::min_speed, Number{0, kAnyMagnitude}),
    field("max_speed", &StrokeBounds::max_speed, Number{0, kAnyMagnitude}),
    field("own_speed", &StrokeBounds::own_speed, Number{0, kAnyMagnitude}),
    field("max_offset", &StrokeBounds::max_offset, Number{0, 1}),
    field("max_elevation", &StrokeBounds::max_elevation, Number{0, kAnyMagnitude}),
};

template <>
inline constexpr auto kFields<Legal> = std::tuple{
    field("seat", &Legal::seat),
    field("place", &Legal::place),
    field("shoot", &Legal::shoot),
    field("aim", &Legal::aim, Direction{}),
};

/// What is legal, with bounds that leave something between them.
struct LegalCodec {
    [[nodiscard]] bool read(const Cursor& cursor, Legal& legal) const;
    [[nodiscard]] Json write(const Legal& legal, Encoding encoding) const;
};

template <>
inline constexpr auto kFields<Ruling> = std::tuple{
    field("verdict", &Ruling::verdict),
    field("shooter", &Ruling::shooter),
    field("next", &Ruling::next),
    field("winner", &Ruling::winner),
    field("decided_at", &Ruling::decided_at, Number{0, kAnyMagnitude}),
};

}  // namespace poolhall::protocol::wire
