#pragma once

#include "shared/math/vec3.hpp"
#include "shared/physics/contact/ball_ball.hpp"

#include <cstdint>

namespace poolhall {

/// The coefficient of friction between two balls, as a scene gives it: mu, or a + b exp(-c u) of
/// the slip speed u (Alciatore, TP A.14); 0 where its impacts are without friction.
class BallFriction {
  public:
    explicit BallFriction(const BallBallSpec& spec);

    /// Of surfaces that slip on each other at `slip_speed` (m/s, not negative).
    [[nodiscard]] Real coefficient(Real slip_speed) const;

  private:
    Real a_ = 0;
    Real b_ = 0;
    Real c_ = 0;  ///< s/m
};

/// One ball of an impact.
struct ImpactBall {
    Vec3 v;           ///< m/s
    Vec3 w;           ///< rad/s
    Real radius = 0;  ///< m
    Real mass = 0;    ///< kg
};

/// What becomes of the vertical part of a friction impulse; the spins get their full share anyhow.
enum class VerticalPart : std::uint8_t {
    kToSlate,  ///< v.z stays: balls on the cloth (so in pooltool)
    kToBalls,  ///< of which one flies
};

/// The velocity (m/s) at which the surface of a slips on that of b, at the unit normal n from a to
/// b: tangential, and not changed by any impulse along n.
[[nodiscard]] Vec3 slip_velocity(Vec3 n, const ImpactBall& a, const ImpactBall& b);

/// The impulse (kg m/s) of friction on b; that on a is its opposite. Against the slip of a on b,
/// mu times `normal_impulse` (kg m/s, not negative), but no more than ends the slip: for equal
/// balls a seventh of it times the mass (Alciatore, TP A.14; unequal ones: PHYSICS.md).
[[nodiscard]] Vec3 friction_impulse(const BallFriction& friction, Real normal_impulse, Vec3 n,
                                    const ImpactBall& a, const ImpactBall& b);

/// Gives `impulse` to b and its opposite to a, where they touch.
void apply_tangential(Vec3 impulse, Vec3 n, VerticalPart vertical, ImpactBall& a, ImpactBall& b);

}  // namespace poolhall
