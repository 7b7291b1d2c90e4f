#pragma once

#include "shared/math/vec2.hpp"

#include <algorithm>
#include <cmath>

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

    RailFriction(double sin_theta, double cos_theta, double mu_nose, double mu_cloth)
        : s_(sin_theta), c_(cos_theta), mu_nose_(mu_nose), mu_cloth_(mu_cloth) {}

    /// Change of the slip at the nose after that much normal impulse and friction.
    [[nodiscard]] Vec2 nose_slip(double normal, const Forces& f) const {
        return {-3.5 * f.nose.x - (1 - 2.5 * s_) * f.cloth.x,
                s_ * c_ * normal - (2.5 + s_ * s_) * f.nose.y - (2.5 - s_) * f.cloth.y};
    }

    /// Change of the slip at the cloth.
    [[nodiscard]] Vec2 cloth_slip(double normal, const Forces& f) const {
        return {-(1 - 2.5 * s_) * f.nose.x - 3.5 * f.cloth.x,
                -c_ * normal - (2.5 - s_) * f.nose.y - 3.5 * f.cloth.y};
    }

    /// Change of the velocity into the rail.
    [[nodiscard]] double approach(double normal, const Forces& f) const {
        return s_ * f.nose.y - f.cloth.y - c_ * normal;
    }

    /// Whether the ball, neither contact slipping, is stuck between nose and cloth: both forces lie
    /// within their cones of friction along the line from nose to cloth.
    [[nodiscard]] bool wedges() const { return std::min(mu_nose_, mu_cloth_) * (1 + s_) >= c_; }

    /// Both contacts slip, in these unit directions.
    [[nodiscard]] Forces slipping(Vec2 nose, Vec2 cloth) const {
        const Vec2 at_nose = mu_nose_ * nose;
        return {at_nose, (mu_cloth_ * load(at_nose)) * cloth};
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
    [[nodiscard]] static Forces stop_cloth(Vec2 slip) { return {{}, (1 / 3.5) * slip}; }

    [[nodiscard]] Forces stop_nose(Vec2 slip, Vec2 cloth) const;

  private:
    /// How hard the ball is pressed on the cloth. The nose may lift it; the cloth does not pull.
    [[nodiscard]] double load(Vec2 at_nose) const { return std::max(0.0, s_ + c_ * at_nose.y); }

    [[nodiscard]] Vec2 needed_at_cloth(Vec2 at_nose) const {
        return (1 / 3.5) * cloth_slip(1, {at_nose, {}});
    }

    /// The nose's friction that keeps it at rest if the cloth's is its load times that vector.
    [[nodiscard]] Vec2 needed_at_nose(Vec2 cloth_per_load, double damping) const;

    /// Solves (M + damping) f = slip, where M f is the slip that friction f ends at the nose.
    [[nodiscard]] Vec2 nose_friction(Vec2 slip, Vec2 cloth_per_load, double damping) const;

    [[nodiscard]] Vec2 limited_at_nose(Vec2 cloth_per_load) const;

    double s_;
    double c_;
    double mu_nose_;
    double mu_cloth_;
};

}  // namespace poolhall
