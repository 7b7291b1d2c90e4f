#pragma once

#include "shared/math/vec2.hpp"

#include <algorithm>

namespace poolhall {

/// A contact at which the ball may slip: slip = start + unit * change, in a scale of its own, so
/// that a ball that grazes the rail at 1e-300 of its speed loses nothing.
class SlidingContact {
  public:
    SlidingContact(Vec2 slip, Real approach, Real mu) : slips_(mu > 0) {
        const Real scale = std::max({abs(slip.x), abs(slip.y), approach});
        start_ = {slip.x / scale, slip.y / scale};
        unit_ = approach / scale;
    }

    [[nodiscard]] bool at_rest() const { return at_rest_; }

    void set_at_rest(bool at_rest) { at_rest_ = at_rest; }

    /// A slip too slow to matter, `still` at most, goes on in the direction of that force.
    void set_out_along(Vec2 force, Real still) {
        const Real square = dot(force, force);
        if (!(square > 0)) return;
        direction_ = (1 / sqrt(square)) * force;
        still_ = still;
    }

    /// The direction of the last slip that could be told from rounding.
    [[nodiscard]] Vec2 last_direction() const { return direction_; }

    [[nodiscard]] bool slower_than(Real speed, Vec2 change) const {
        const Vec2 now = slip(change);
        return slips_ && dot(now, now) <= speed * unit_ * speed * unit_;
    }

    /// Whether there is no slip that could be told from rounding, or one all but along that.
    [[nodiscard]] bool sets_out_in(Vec2 direction, Vec2 change) const {
        constexpr Real kAligned = 0.01;
        const Vec2 now = slip(change);
        return slower_than(kRounding, change) ||
               (dot(now, direction) > 0 &&
                abs(cross(now, direction)) < kAligned * dot(now, direction));
    }

    /// How fast it slips, in units of the approach, or some times that where it slips ever faster:
    /// the impulse in which the slip may end or turn round. Infinite where it does not slip, or
    /// sets out.
    [[nodiscard]] Real pace(Vec2 change, Vec2 rate) const {
        constexpr Real kOpening = 4;
        const Vec2 now = slip(change);
        const Real square = dot(now, now);
        if (at_rest_ || !slips_ || square <= still_ * unit_ * still_ * unit_) return kInfinity;
        return (dot(now, rate) > 0 ? kOpening : 1) * sqrt(square) / unit_;
    }

    /// In units of the approach, of a slow slip.
    [[nodiscard]] Vec2 slow_slip(Vec2 change) const { return (1 / unit_) * slip(change); }

    /// Where the slip all but vanishes, its last direction, so that a step may end in rest.
    [[nodiscard]] Vec2 direction(Vec2 change) const { return direction_of(slip(change)); }

    /// The same of a slip in the contact's own scale.
    [[nodiscard]] Vec2 direction_of(Vec2 now) const {
        const Real square = dot(now, now);
        return square > still_ * unit_ * still_ * unit_ ? (1 / sqrt(square)) * now : direction_;
    }

    /// In its own scale.
    [[nodiscard]] Vec2 slip(Vec2 change) const { return start_ + unit_ * change; }

    [[nodiscard]] Real unit() const { return unit_; }

    /// To be called between steps.
    void remember_direction(Vec2 change) {
        direction_ = direction(change);
        still_ = kRounding;
    }

    /// The impulse after which the slip vanishes, if it goes on to change at that rate; nothing if
    /// it passes zero at a distance.
    [[nodiscard]] Real until_rest(Vec2 change, Vec2 rate) const {
        constexpr Real kAimed = 0.1;  // sine of the angle by which it misses
        const Vec2 now = slip(change);
        const Real closing = -dot(now, rate);
        if (at_rest_ || !slips_ || !(closing > 0)) return kInfinity;
        if (abs(cross(now, rate)) > kAimed * closing) return kInfinity;
        return closing / dot(rate, rate) / unit_;
    }

  private:
    static constexpr Real kRounding = 1e-12;

    Vec2 start_;
    Real unit_ = 1;
    Vec2 direction_;
    Real still_ = kRounding;  ///< slips up to this have direction_, in units of the approach
    bool slips_;
    bool at_rest_ = false;
};

}  // namespace poolhall
