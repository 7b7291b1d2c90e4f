#pragma once

#include "shared/math/vec2.hpp"

#include <algorithm>

namespace poolhall {

/// Friction of a ball that is pressed against a rail's nose and the cloth, in the frame of
/// rail_frame.hpp. Everything is per unit of the nose's normal impulse and of the ball's mass.
class RailFriction {
  public:
    /// What friction takes from the ball: x along the rail; y up the nose's face, into the rail.
    struct Forces {
        Vec2 nose;
        Vec2 cloth;
    };

    RailFriction(Real sin_theta, Real cos_theta, Real mu_nose, Real mu_cloth)
        : s_(sin_theta),
          c_(cos_theta),
          mu_nose_(mu_nose),
          mu_cloth_(mu_cloth),
          rub_(mu_cloth * sin_theta),
          rub_by_nose_(mu_cloth * cos_theta * mu_nose) {}

    /// Change of the slip at the nose after that much normal impulse and friction.
    [[nodiscard]] Vec2 nose_slip(Real normal, const Forces& f) const {
        return {-3.5 * f.nose.x - (1 - 2.5 * s_) * f.cloth.x,
                s_ * c_ * normal - (2.5 + s_ * s_) * f.nose.y - (2.5 - s_) * f.cloth.y};
    }

    /// Change of the slip at the cloth.
    [[nodiscard]] Vec2 cloth_slip(Real normal, const Forces& f) const {
        return {-(1 - 2.5 * s_) * f.nose.x - 3.5 * f.cloth.x,
                -c_ * normal - (2.5 - s_) * f.nose.y - 3.5 * f.cloth.y};
    }

    /// Change of the velocity into the rail.
    [[nodiscard]] Real approach(Real normal, const Forces& f) const {
        return s_ * f.nose.y - f.cloth.y - c_ * normal;
    }

    /// Whether the ball, neither contact slipping, is stuck between nose and cloth: both forces lie
    /// within their cones of friction along the line from nose to cloth.
    [[nodiscard]] bool wedges() const { return std::min(mu_nose_, mu_cloth_) * (1 + s_) >= c_; }

    /// Both contacts slip, in these unit directions.
    [[nodiscard]] Forces slipping(Vec2 nose, Vec2 cloth) const {
        return {mu_nose_ * nose, std::max(Real{0}, rub_ + rub_by_nose_ * nose.y) * cloth};
    }

    /// The cloth does not slip: it gives what keeps it so, or all that it has.
    [[nodiscard]] Forces cloth_at_rest(Vec2 nose) const;

    /// The nose does not slip, the cloth slips in that unit direction: likewise. The nose's
    /// friction presses the ball on the cloth, which pushes back on the nose's slip.
    [[nodiscard]] Forces nose_at_rest(Vec2 cloth) const;

    /// Whether friction suffices to keep a contact at rest while the other slips.
    [[nodiscard]] bool cloth_holds(Vec2 nose) const;
    [[nodiscard]] bool nose_holds(Vec2 cloth) const;

    /// The friction impulse that ends a slip at once while the other contact goes on slipping.
    [[nodiscard]] static Forces stop_cloth(Vec2 slip) { return {{}, (1 / Real{3.5}) * slip}; }

    [[nodiscard]] Forces stop_nose(Vec2 slip, Vec2 cloth) const;

  private:
    /// How hard the ball is pressed on the cloth. The nose may lift it; the cloth does not pull.
    [[nodiscard]] Real load(Vec2 at_nose) const { return std::max(Real{0}, s_ + c_ * at_nose.y); }

    [[nodiscard]] Vec2 needed_at_cloth(Vec2 at_nose) const {
        return (1 / Real{3.5}) * cloth_slip(1, {at_nose, {}});
    }

    /// The nose's friction that keeps it at rest if the cloth's is its load times that vector.
    [[nodiscard]] Vec2 needed_at_nose(Vec2 cloth_per_load, Real damping) const;

    /// Solves (M + damping) f = slip, where M f is the slip that friction f ends at the nose.
    [[nodiscard]] Vec2 nose_friction(Vec2 slip, Vec2 cloth_per_load, Real damping) const;

    [[nodiscard]] Vec2 limited_at_nose(Vec2 cloth_per_load) const;

    Real s_;
    Real c_;
    Real mu_nose_;
    Real mu_cloth_;
    Real rub_;          ///< the cloth's friction where nothing lifts the ball
    Real rub_by_nose_;  ///< what the nose's friction adds to it at most
};

}  // namespace poolhall
