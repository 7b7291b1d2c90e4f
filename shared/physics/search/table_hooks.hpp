#pragma once

#include "shared/physics/motion/arc.hpp"
#include "shared/physics/search/box.hpp"
#include "shared/table/pockets.hpp"

#include <type_traits>

// How an effect tells the searches where a ball meets something of the table. As with the cloth
// (cloth_hooks.hpp) they ask for these hooks, never for an effect by name.
namespace poolhall {

struct CushionHit {
    Real t = 0;  ///< s from now
    Rail rail = Rail::kNorth;
    Vec2 normal;  ///< unit, into the rubber
};

/// False for a line of rubber that a ball is behind: one in a mouth would meet noses that go on
/// beyond their ends, and the backs of facings. `gap` (m) is how far its surface is from the line.
[[nodiscard]] inline bool faces(Real gap) {
    return gap >= -kTouchTolerance;
}

/// A dead cushion leaves nothing but rounding of what came in, m/s. No impact would end that.
[[nodiscard]] inline Real rounding_of(Vec2 v) {
    return kTouchRounding * (abs(v.x) + abs(v.y));
}

/// The four straight, unbroken rails, where the table has them.
template <class Effect>
concept StraightRailEffect = requires(const Effect& effect, const MovingBall& ball, Vec2 v) {
    effect.is_there();
    effect.edge(Real{});  // |x| and |y| of a ball of that reach that touches them, m
    effect.may_reach(ball, v, Real{});
    effect.next_short_rail(ball, v);
    effect.next_long_rail(ball, v);
};

/// Rubber of other shapes: the lines and arcs of a PoolTable.
template <class Effect>
concept CushionEffect = requires(const Effect& effect, const MovingBall& ball, Vec2 v, Box box) {
    effect.may_reach(box);
    effect.may_reach(ball, v, Real{});
    effect.straight_hit(ball, v);
    effect.table().lines();
    effect.table().arcs();
};

/// Takes balls that come to a place.
template <class Effect>
concept PocketEffect = requires(const Effect& effect, Vec2 r) {
    effect.first_capture(r, r, Real{});
    effect.at(r);
};

/// Pockets that know their first capture on an arc.
template <class Effect>
concept ArcPocketEffect = requires(const Effect& effect, const MovingBall& ball, const Arc& arc) {
    effect.first_capture_on(ball, arc);
};

/// Pockets that are circles; may_reach() is false where none is near.
template <class Effect>
concept CirclePocketEffect = requires(const Effect& effect, Box box) {
    effect.may_reach(box);
    effect.circles();
    effect.pocket_of(std::size_t{});
};

/// Can say up to which |x| and |y| (m) the centre of a ball of some radius (m) meets nothing of it.
template <class Effect>
concept OuterEffect = requires(const Effect& effect) {
    effect.clear_area(Real{});
};

namespace hooks {

template <class Effect>
struct StraightRails : std::bool_constant<StraightRailEffect<Effect>> {};

template <class Effect>
struct Cushions : std::bool_constant<CushionEffect<Effect>> {};

}  // namespace hooks

}  // namespace poolhall
