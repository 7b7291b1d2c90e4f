#pragma once

#include "shared/math/vec2.hpp"
#include "shared/physics/contact/time_of_impact.hpp"
#include "shared/table/pockets.hpp"

#include <cstddef>
#include <optional>

namespace poolhall {

/// True if r is in the circle, which has a centre and a radius.
template <class Circle>
[[nodiscard]] bool is_in_circle(const Circle& circle, Vec2 r) {
    const Vec2 c = r - circle.centre;
    return dot(c, c) <= circle.radius * circle.radius;
}

/// The first capture of a point that moves from r with velocity v, within `time` s, by one of the
/// circles; pocket_of(i) is the pocket of the i-th.
template <class Circles, class PocketOf>
[[nodiscard]] std::optional<Capture> first_capture_by(const Circles& circles, PocketOf pocket_of,
                                                      const UniformMotion& point, Real time) {
    std::optional<Capture> first;
    for (std::size_t i = 0; i < circles.size(); ++i) {
        const std::optional<Real> t =
            is_in_circle(circles[i], point.r)
                ? 0
                : time_of_impact(point, {circles[i].centre, {}}, circles[i].radius);
        if (t && *t <= time && (!first || *t < first->t)) first = Capture{*t, pocket_of(i)};
    }
    return first;
}

}  // namespace poolhall
