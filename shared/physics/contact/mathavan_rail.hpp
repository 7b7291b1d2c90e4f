#pragma once

#include "shared/math/vec3.hpp"
#include "shared/physics/contact/rail_contact.hpp"

namespace poolhall {

/// How finely an impact is integrated. All relative to the speed of approach.
struct ImpactPrecision {
    Real longest_step = 1;  ///< of the nose's impulse
    Real tolerance = 3e-8;  ///< of the estimated error of a step
    Real rest_slip = 5e-6;  ///< a slip as slow as this ends at once, if friction can hold it
};

inline constexpr ImpactPrecision kExactImpact{};
inline constexpr ImpactPrecision kFastImpact{1, 1e-4, 1e-3};

/// Impact on a rail after Mathavan, Jackson, Parkin, "A theoretical analysis of billiard ball
/// dynamics under cushion impacts", Proc. IMechE C 224(9), 2010, 1863-1873: friction at the nose
/// and at the cloth, both of which may slip, stick and slip again, while the nose's impulse grows
/// and then, until it has given back e^2 of its work, shrinks. v m/s, w rad/s. Without friction
/// v_n becomes -e v_n.
///
/// Integrated in the nose's impulse with Dormand and Prince's fifth-order pair, each phase to its
/// exact end. Where mu and mu_table are so high, both near 1, that the ball is wedged between nose
/// and cloth, it stops there. The number of steps is bounded for any input.
///
/// Error, relative to the speed of approach, mu up to 0.4: median 1e-8, 99 % of impacts below 1e-6,
/// all of 2000 below 1e-5; where a slip creeps for long, about one in 6000, it reaches 1e-3.
/// Cost of a hit: about 6 us, 55,000 instructions (tests/bench, rail_impact).
void bounce_mathavan2010(const RailContact& rail, Vec3& v, Vec3& w);

/// At half the cost, 3 us and 31,000 instructions: median error 1e-6, 99 % below 4e-3,
/// all of 2000 below 2e-2; worst where a slip stops.
void bounce_mathavan2010_fast(const RailContact& rail, Vec3& v, Vec3& w);

/// With a precision of choice, to show how it converges.
void bounce_mathavan2010(const RailContact& rail, const ImpactPrecision& precision, Vec3& v,
                         Vec3& w);

}  // namespace poolhall
