#include "shared/physics/effects/end_game_pockets.hpp"

#include "shared/physics/contact/contact_time.hpp"

#include <algorithm>
#include <array>

namespace poolhall {

namespace {

/// As good as for ever, but 0 times it is 0.
constexpr Real kForever = 1e300;

/// Instants in (0, horizon) at which something may change, rising, after the first, 0.
class Instants {
  public:
    explicit Instants(Real horizon) : horizon_(horizon) {}

    void add(Real t) {
        if (t > 0 && t < horizon_) times_[count_++] = t;
    }

    /// Both roots of x + v t + a t^2 / 2 = edge.
    void add_crossings(Real x, Real v, Real a, Real edge) {
        const Real discriminant = v * v - 2 * a * (x - edge);
        if (discriminant < 0) return;
        const Real q = -(v + (v < 0 ? -1 : 1) * sqrt(discriminant));
        if (a != 0) add(q / a);
        if (q != 0) add(2 * (x - edge) / q);
    }

    template <class Holds>
    [[nodiscard]] std::optional<Real> first_beginning_of(Holds holds) {
        std::sort(times_.begin(), times_.begin() + static_cast<std::ptrdiff_t>(count_));
        times_[count_] = horizon_;
        for (std::size_t k = 0; k < count_; ++k) {
            if (holds(times_[k] + (times_[k + 1] - times_[k]) / 2)) return times_[k];
        }
        return std::nullopt;
    }

  private:
    Real horizon_;
    std::array<Real, 1 + 12 + 1> times_{};
    std::size_t count_ = 1;
};

}  // namespace

std::optional<Capture> EndGamePockets::first_capture_on(const MovingBall& ball,
                                                        const Arc& arc) const {
    if (!active_) return std::nullopt;
    const Real horizon = std::min(arc.until - arc.since, kForever);
    if (arc.a == Vec2{}) {
        const Real way = way_under_drag(arc.drag, horizon);
        std::optional<Capture> capture = map_.first_capture(ball.r, ball.v, way);
        if (capture) capture->t = time_under_drag(arc.drag, capture->t);
        return capture;
    }
    Instants instants(horizon);
    for (const Real sign : {1.0, -1.0}) {
        instants.add_crossings(ball.r.y, ball.v.y, arc.a.y, sign * map_.near_rail_y());
        instants.add_crossings(ball.r.x, ball.v.x, arc.a.x, sign * map_.corner_x());
        instants.add_crossings(ball.r.x, ball.v.x, arc.a.x, sign * map_.centre_x());
    }
    std::optional<Pocket> pocket;
    const auto t = instants.first_beginning_of([&](Real time) {
        pocket = map_.at(place_on(ball, arc, arc.since + time));
        return pocket.has_value();
    });
    if (!t) return std::nullopt;
    return Capture{*t, *pocket};
}

}  // namespace poolhall
