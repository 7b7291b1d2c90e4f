#pragma once

#include "shared/math/vec2.hpp"

namespace poolhall {

/// The velocities after the elastic impact of two equal balls, at the unit normal n from a to b:
/// the components along n are exchanged (text, 5.2.1). Momentum is kept to rounding because one and
/// the same impulse is added and subtracted.
inline void exchange_normal_velocity(Vec2& v_a, Vec2& v_b, Vec2 n) {
    const Vec2 impulse = dot(v_a - v_b, n) * n;
    v_a = v_a - impulse;
    v_b = v_b + impulse;
}

}  // namespace poolhall
