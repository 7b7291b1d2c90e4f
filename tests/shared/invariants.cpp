#include "tests/shared/invariants.hpp"

#include "shared/table/playing_area.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace poolhall::testing {
namespace {

constexpr double kUlp = 0x1p-52;
constexpr double kNeverGone = std::numeric_limits<double>::infinity();

bool is_finite(const Vec3& a) {
    return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

bool is_finite(const BallState& state) {
    return is_finite(state.r) && is_finite(state.v) && is_finite(state.w);
}

std::string at(double t) {
    return " at t = " + std::to_string(t);
}

std::string broken_order(const ShotTrace& trace) {
    double last = 0;
    for (const ShotEvent& event : trace.events) {
        if (!(event.t >= last) || !std::isfinite(event.t))
            return "event out of order" + at(event.t);
        last = event.t;
        for (std::size_t i = 0; i < event.ball_count; ++i) {
            if (!is_finite(event.before[i]) || !is_finite(event.after[i]))
                return "event with a state that is not finite" + at(event.t);
        }
    }
    for (const FinalBall& ball : trace.balls) {
        if (!is_finite(ball.state)) return "final state that is not finite";
    }
    if (trace.outcome == Outcome::kStalled) return "stalled";
    return {};
}

/// Follows each ball from event to event. The events of one instant go together, since contacts of
/// one group share balls.
class Ledger {
  public:
    explicit Ledger(const Scene& scene)
        : scene_(scene),
          known_(scene.balls.size()),
          before_(scene.balls.size()),
          last_before_(scene.balls.size()),
          involved_(scene.balls.size()) {
        for (std::size_t i = 0; i < known_.size(); ++i)
            known_[i] = scene.balls[i].state;
    }

    std::string broken_by(std::span<const ShotEvent> instant) {
        collect(instant);
        double energy_before = 0;
        double energy_after = 0;
        for (const std::size_t i : order_) {
            const double radius = radius_of(scene_, scene_.balls[i]);
            const double mass = mass_of(scene_, scene_.balls[i]) / scene_.ball.mass;
            const double had = energy_of(known_before_[i], radius);
            const double has = energy_of(before_[i], radius);
            if (!struck_ && height_free() && has > had * (1 + 1e-12) + kRounding)
                return "energy rises between events" + at(instant[0].t);
            energy_before += mass * has;
            energy_after += mass * energy_of(known_[i], radius);
        }
        if (struck_) return {};
        if (energy_after > energy_before * (1 + 1e-13) + allowance_ + kRounding)
            return "energy rises in an impact" + at(instant[0].t);
        return only_balls_ ? broken_momentum(instant[0].t) : std::string{};
    }

  private:
    /// Squares of rounding at the speeds of pool, m^2/s^2.
    static constexpr double kRounding = 1e-18;

    /// In the air potential energy turns into speed.
    [[nodiscard]] bool height_free() const { return !scene_.effects.airborne; }

    void collect(std::span<const ShotEvent> instant) {
        std::fill(involved_.begin(), involved_.end(), false);
        order_.clear();
        known_before_ = known_;
        struck_ = false;
        only_balls_ = true;
        allowance_ = 0;
        drift_ = {};
        for (const ShotEvent& event : instant) {
            struck_ = struck_ || event.kind == EventKind::kStrike;
            only_balls_ = only_balls_ && event.kind == EventKind::kBallBall;
            allowance_ += square_of_slow_parting(event);
            for (std::size_t i = 0; i < event.ball_count; ++i) {
                const std::size_t ball = event.balls[i].value;
                if (!involved_[ball]) {
                    involved_[ball] = true;
                    order_.push_back(ball);
                    before_[ball] = event.before[i];
                } else if (event.before[i] != last_before_[ball]) {
                    drift_ = drift_ + drift_of(ball, event.before[i], event.t);
                }
                last_before_[ball] = event.before[i];
                known_[ball] = event.after[i];
            }
        }
    }

    /// Bodies that the cloth presses together may be parted with this speed, and gain its square:
    /// the least separation, quadrupled up to four times (SlowImpacts in contact.hpp).
    [[nodiscard]] double square_of_slow_parting(const ShotEvent& event) const {
        const double most = 256 * scene_.effects.ball_ball.min_separation;
        double speed = 0;
        if (event.kind == EventKind::kBallBall) {
            const Vec3 n = event.after[1].r - event.after[0].r;
            speed = dot(event.after[1].v - event.after[0].v, n) / norm(n);
        } else if (event.kind == EventKind::kBallRail) {
            const Vec2 v = xy(event.after[0].v);
            const bool short_rail = event.rail == Rail::kEast || event.rail == Rail::kWest;
            speed = event.rail >= kFirstJaw ? most : std::abs(short_rail ? v.x : v.y);
        }
        return speed <= most * (1 + 1e-9) ? speed * speed : 0;
    }

    /// Rounding may make one instant of two; between them the cloth has slowed the ball, but no
    /// longer than that rounding. kg m/s over the kg of a ball.
    [[nodiscard]] Vec2 drift_of(std::size_t ball, const BallState& next, double t) const {
        const Vec2 change = xy(next.v) - xy(known_[ball].v);
        const double mass = mass_of(scene_, scene_.balls[ball]) / scene_.ball.mass;
        return norm(change) <= 2 * kUlp * t * scene_.gravity ? mass * change : Vec2{};
    }

    [[nodiscard]] std::string broken_momentum(double t) const {
        Vec2 change = -drift_;
        double scale = 0;
        for (const std::size_t i : order_) {
            const double mass = mass_of(scene_, scene_.balls[i]) / scene_.ball.mass;
            change = change + mass * (xy(known_[i].v) - xy(before_[i].v));
            scale += mass * std::max(norm(xy(known_[i].v)), norm(xy(before_[i].v)));
        }
        // Of bodies that fall upon each other the vertical momentum goes to the slate.
        if (norm(change) <= 4 * kUlp * scale) return {};
        return "momentum changes in an impact" + at(t);
    }

    const Scene& scene_;
    std::vector<BallState> known_;  ///< after the ball's last event
    std::vector<BallState> known_before_;
    std::vector<BallState> before_;       ///< the instant
    std::vector<BallState> last_before_;  ///< the ball's last event
    Vec2 drift_;                          ///< of momentum within the instant
    std::vector<bool> involved_;
    std::vector<std::size_t> order_;
    bool struck_ = false;
    bool only_balls_ = true;
    double allowance_ = 0;
};

std::string broken_balance(const Scene& scene, const ShotTrace& trace) {
    // Its impacts of one tick come in the order of its scan, with times that are guesses.
    if (trace.solver == SolverKind::kOverlap) return {};
    Ledger ledger(scene);
    const std::span<const ShotEvent> events(trace.events);
    for (std::size_t first = 0; first < events.size();) {
        std::size_t last = first + 1;
        while (last < events.size() && events[last].t == events[first].t)
            ++last;
        std::string broken = ledger.broken_by(events.subspan(first, last - first));
        if (!broken.empty()) return broken;
        first = last;
    }
    return {};
}

/// When each ball leaves play, s.
std::vector<double> times_gone(const Scene& scene, const ShotTrace& trace) {
    std::vector<double> gone(scene.balls.size(), kNeverGone);
    for (const ShotEvent& event : trace.events) {
        if (event.kind == EventKind::kBallPocket || event.kind == EventKind::kOffTable)
            gone[event.balls[0].value] = event.t;
    }
    return gone;
}

std::string broken_places(const Scene& scene, const ShotTrace& trace, double tolerance) {
    const std::vector<double> gone = times_gone(scene, trace);
    for (std::size_t k = 0; k < trace.sample_count(); ++k) {
        const double t = static_cast<double>(k) / trace.sample_hz;
        for (std::size_t a = 0; a < scene.balls.size(); ++a) {
            if (t >= gone[a]) continue;
            const Vec3& r = trace.sample(k, a);
            const double radius = radius_of(scene, scene.balls[a]);
            if (!is_finite(r)) return "place that is not finite" + at(t);
            if (!is_on_table(scene.table, xy(r), radius, tolerance))
                return "ball off the table" + at(t);
            for (std::size_t b = 0; b < a; ++b) {
                if (t >= gone[b]) continue;
                const double other = radius_of(scene, scene.balls[b]);
                Vec3 gap = r - trace.sample(k, b);
                gap.z = gap.z + (radius - other);
                if (norm(gap) < radius + other - tolerance) return "overlap" + at(t);
            }
        }
    }
    return {};
}

}  // namespace

double energy_of(const BallState& state, double radius) {
    return dot(state.v, state.v) / 2 + radius * radius * dot(state.w, state.w) / 5;
}

std::string broken_invariant(const Scene& scene, const ShotTrace& trace, double tolerance) {
    if (std::string broken = broken_order(trace); !broken.empty()) return broken;
    if (std::string broken = broken_balance(scene, trace); !broken.empty()) return broken;
    return broken_places(scene, trace, tolerance);
}

}  // namespace poolhall::testing
