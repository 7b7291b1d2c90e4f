#include "client/lab/ensembles/unfolding.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <cstdint>

namespace poolhall::lab {

namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;

/// One coordinate of the unfolded way.
class Axis {
  public:
    Axis(const Quad& start, const Quad& speed, double edge, Rail positive, Rail negative)
        : start_(start),
          speed_(speed),
          edge_(edge),
          first_(speed > 0 ? positive : negative),
          second_(speed > 0 ? negative : positive) {}

    /// The part of the ball's whole way after which it meets the next rail of this axis.
    [[nodiscard]] Quad next_rail(const Quad& way) const {
        if (speed_ == 0) return 2;
        const Quad ahead = speed_ > 0 ? start_ : Quad(-start_);
        return ((2 * rails_ + 1) * edge_ - ahead) / (abs(speed_) * way);
    }

    /// Passes it.
    Rail pass() { return rails_++ % 2 == 0 ? first_ : second_; }

    /// Where the ball is after so much way.
    [[nodiscard]] double place(const Quad& way) const {
        const Quad images = 2 * rails_ * edge_;
        return (turn() * (start_ + speed_ * way - (speed_ > 0 ? images : Quad(-images))))
            .convert_to<double>();
    }

    /// 1, or -1 after an odd number of rails.
    [[nodiscard]] int turn() const { return rails_ % 2 == 0 ? 1 : -1; }

    /// Part of the ball's speed along this axis, with its sign.
    [[nodiscard]] Quad share() const { return turn() * speed_; }

  private:
    Quad start_;
    Quad speed_;  ///< over the ball's: from -1 to 1
    Quad edge_;   ///< m
    Rail first_;
    Rail second_;
    std::uint64_t rails_ = 0;  ///< passed
};

/// The ball on its way, which goes from 0 to 1.
class Roll {
  public:
    explicit Roll(const Scene& scene) : state_(scene.balls[0].state) {
        const Quad vx = state_.v.x;
        const Quad vy = state_.v.y;
        speed_ = sqrt(vx * vx + vy * vy);
        deceleration_ = Quad(scene.effects.rolling->mu) * Quad(scene.gravity);
        way_ = speed_ * speed_ / (2 * deceleration_);
        const Vec2 edge = inset(scene.table, scene.ball.radius);
        x_ = Axis(state_.r.x, vx / speed_, edge.x, Rail::kEast, Rail::kWest);
        y_ = Axis(state_.r.y, vy / speed_, edge.y, Rail::kNorth, Rail::kSouth);
    }

    /// The part of the way after which the next rail comes; more than 1 where none does.
    [[nodiscard]] Quad next_rail() const {
        return std::min(x_.next_rail(way_), y_.next_rail(way_));
    }

    Rail pass() { return x_.next_rail(way_) <= y_.next_rail(way_) ? x_.pass() : y_.pass(); }

    /// After a part of the way: v^2 = v0^2 (1 - part).
    [[nodiscard]] BallState state(const Quad& part) const {
        const Quad speed = speed_ * sqrt(Quad(1 - part));
        BallState state = state_;
        set_xy(state.r, {x_.place(part * way_), y_.place(part * way_)});
        set_xy(state.v, {Quad(speed * x_.share()).convert_to<double>(),
                         Quad(speed * y_.share()).convert_to<double>()});
        return state;
    }

    [[nodiscard]] Quad duration() const { return speed_ / deceleration_; }

    /// When it has gone a part of the way, s: v falls linearly.
    [[nodiscard]] double time(const Quad& part) const {
        // 1 - sqrt(1 - part), without cancellation.
        return Quad(duration() * part / (1 + sqrt(Quad(1 - part)))).convert_to<double>();
    }

    /// What part of the way it has gone at a time, s.
    [[nodiscard]] Quad part(double t) const {
        const Quad left = 1 - std::min(Quad(Quad(t) / duration()), Quad(1));
        return 1 - left * left;
    }

  private:
    BallState state_;
    Quad speed_;
    Quad deceleration_;
    Quad way_;
    Axis x_{0, 0, 0, Rail::kEast, Rail::kWest};
    Axis y_{0, 0, 0, Rail::kNorth, Rail::kSouth};
};

ShotEvent event_at(double t, EventKind kind, const BallState& before, const BallState& after) {
    ShotEvent event;
    event.t = t;
    event.kind = kind;
    event.before[0] = before;
    event.after[0] = after;
    return event;
}

/// Up to the first sample at or after the end.
void sample(const Scene& scene, double hz, ShotTrace& trace) {
    Roll roll(scene);
    for (std::uint64_t k = 0;; ++k) {
        const double t = static_cast<double>(k) / hz;
        const Quad part = roll.part(t);
        while (roll.next_rail() <= part)
            roll.pass();
        trace.samples.push_back(roll.state(part).r);
        if (t >= trace.duration) return;
    }
}

}  // namespace

void unfold(const Scene& scene, double sample_hz, ShotTrace& trace) {
    trace = ShotTrace{};
    trace.solver = SolverKind::kEvent;
    trace.sample_hz = sample_hz;
    Roll roll(scene);
    for (Quad part = roll.next_rail(); part < 1; part = roll.next_rail()) {
        const BallState before = roll.state(part);
        const Rail rail = roll.pass();
        trace.events.push_back(
            event_at(roll.time(part), EventKind::kBallRail, before, roll.state(part)));
        trace.events.back().rail = rail;
    }
    const BallState rest = roll.state(1);
    trace.duration = roll.duration().convert_to<double>();
    trace.events.push_back(event_at(trace.duration, EventKind::kRollToRest, rest, rest));
    trace.balls = {{Motion::kStationary, {}, rest}};
    if (sample_hz > 0) sample(scene, sample_hz, trace);
}

}  // namespace poolhall::lab
