#pragma once

#include "shared/physics/contact.hpp"
#include "shared/physics/effects/effect_set.hpp"
#include "shared/physics/shot_run.hpp"
#include "shared/physics/solvers/stepping.hpp"
#include "shared/physics/time_of_impact.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

namespace poolhall {

/// More contacts than this within one tick end the shot as stalled: balls that are this fast are no
/// pool.
inline constexpr int kMaxContactsPerTick = 10000;

/// The next double after x >= 0; std::nextafter would be a call of the C library.
constexpr double next_above(double x) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) + 1);
}

/// Explicit Euler steps of 1 / hz: r += v dt, then the velocities change. Between two ticks motion
/// is uniform, so contacts are found by their time of impact, earliest first, as many as there are:
/// nothing tunnels at any speed.
template <class Set>
class EulerSolver {
  public:
    EulerSolver(const Set& set, ShotRun& run) : set_(set), run_(run) {}

    void solve() {
        run_ticks(run_, [this](double begin, double end) { return tick(begin, end); });
    }

  private:
    /// One tick from `begin` to `end`, in s. kRest means that it went well.
    Outcome tick(double begin, double end) {
        const double dt = end - begin;
        double passed = 0;
        for (int round = 0; round < kMaxContactsPerTick; ++round) {
            if (run_.event_limit_reached()) return Outcome::kEventLimit;
            const double rest = std::max(dt - passed, 0.0);
            const double next = next_instant(rest);
            if (next > rest) {
                advance(begin + passed, end, rest);
                if constexpr (Set::template kHas<LinearDrag>) {
                    slow_down(run_, set_.template effect<LinearDrag>(), dt, end);
                }
                run_.sample_at(end);
                return Outcome::kRest;
            }
            advance(begin + passed, end, next);
            passed += next;
            // Rounded, it could lie behind the tick's end, and its event behind those of the next.
            if (!happen(std::min(begin + passed, end))) return Outcome::kStalled;
        }
        return Outcome::kStalled;
    }

    void advance(double from, double tick_end, double time) {
        run_.sample_between(from, std::min(from + time, tick_end));
        for (MovingBall& ball : run_.balls())
            ball.r = ball.r + time * ball.v;
    }

    /// Collects what happens first within `time` s, and returns when; more than `time` if nothing
    /// does.
    double next_instant(double time) {
        contacts_.clear();
        captures_.clear();
        first_ = next_above(time);
        if constexpr (Set::template kHas<EndGamePockets>) find_captures(time);
        find_ball_contacts();
        if constexpr (Set::template kHas<Rails>) find_rail_contacts();
        return first_;
    }

    /// True if an event at t is among the first; forgets later ones.
    bool is_first(double t) {
        if (t > first_) return false;
        if (t < first_) {
            contacts_.clear();
            captures_.clear();
        }
        first_ = t;
        return true;
    }

    void find_captures(double time) {
        const auto& pockets = set_.template effect<EndGamePockets>();
        for (std::size_t i = 0; i < run_.balls().size(); ++i) {
            const MovingBall& ball = run_.balls()[i];
            if (!ball.in_play || ball.v == Vec2{}) continue;
            const std::optional<Capture> capture = pockets.first_capture(ball.r, ball.v, time);
            if (capture && is_first(capture->t)) captures_.push_back({i, capture->pocket});
        }
    }

    void find_ball_contacts() {
        const std::vector<MovingBall>& balls = run_.balls();
        const double distance = 2 * run_.scene().ball.radius;
        for (std::size_t a = 0; a < balls.size(); ++a) {
            for (std::size_t b = a + 1; b < balls.size(); ++b) {
                if (!balls[a].in_play || !balls[b].in_play || balls[a].v == balls[b].v) continue;
                if (balls[a].partner == b && balls[b].partner == a) continue;
                if (!may_meet(balls[a], balls[b], distance)) continue;
                const std::optional<double> t =
                    time_of_impact({balls[a].r, balls[a].v}, {balls[b].r, balls[b].v}, distance);
                if (!t || rest_against(balls[a], balls[b], distance)) continue;
                if (is_first(*t)) contacts_.push_back({Contact::Kind::kBalls, a, b, Rail::kNorth});
            }
        }
    }

    /// False where the balls cannot meet before the first event known: boxes around their ways,
    /// wider than any rounding.
    [[nodiscard]] bool may_meet(const MovingBall& a, const MovingBall& b, double distance) const {
        constexpr double kGenerous = 1 + 0x1p-30;
        const Vec2 c = b.r - a.r;
        const Vec2 v = b.v - a.v;
        return std::abs(c.x) <= kGenerous * (distance + std::abs(v.x) * first_) &&
               std::abs(c.y) <= kGenerous * (distance + std::abs(v.y) * first_);
    }

    /// True for balls that touch and approach no more than rounding makes them. An impact would
    /// only hand that rounding to and fro between them and what holds them, without end; left alone
    /// it makes an overlap far below kTouchTolerance.
    [[nodiscard]] static bool rest_against(const MovingBall& a, const MovingBall& b,
                                           double distance) {
        constexpr double kRounding = 0x1p-48;
        const Vec2 c = b.r - a.r;
        const double speed =
            std::max({std::abs(a.v.x), std::abs(a.v.y), std::abs(b.v.x), std::abs(b.v.y)});
        return dot(c, c) <= (1 + kRounding) * distance * distance &&
               -dot(c, b.v - a.v) <= kRounding * distance * speed;
    }

    void find_rail_contacts() {
        const auto& rails = set_.template effect<Rails>();
        for (std::size_t i = 0; i < run_.balls().size(); ++i) {
            const MovingBall& ball = run_.balls()[i];
            if (!ball.in_play || !rails.may_reach(ball.r, ball.v, first_)) continue;
            for (const auto& hit :
                 {rails.next_short_rail(ball.r, ball.v), rails.next_long_rail(ball.r, ball.v)}) {
                if (hit && is_first(hit->t))
                    contacts_.push_back({Contact::Kind::kRail, i, 0, hit->rail});
            }
        }
    }

    /// Lets happen what next_instant() found: captures, or else the contacts as one group.
    bool happen(double t) {
        if constexpr (Set::template kHas<EndGamePockets>) {
            for (const auto& [ball, pocket] : captures_)
                run_.capture(t, ball, pocket);
            // A captured ball takes part in nothing else; what remains is found again, 0 s from
            // here.
            if (!captures_.empty()) return true;
        }
        if constexpr (Set::template kHas<Rails>) snap_to_rails();
        before_.clear();
        for (const Contact& contact : contacts_)
            before_.push_back({run_.balls()[contact.a], run_.balls()[contact.b]});
        if (!resolve(contacts_, restitution(), run_.balls())) return false;
        for (std::size_t i = 0; i < contacts_.size(); ++i) {
            const auto& [kind, a, b, rail] = contacts_[i];
            if (kind == Contact::Kind::kRail) {
                run_.record_rail(t, a, rail, before_[i].a);
            } else {
                run_.record_pair(t, a, b, before_[i].a, before_[i].b);
            }
        }
        return true;
    }

    /// r + v t rounds; at a rail the right coordinate is known, and a million bounces stay exact.
    void snap_to_rails() {
        const Vec2 edge = set_.template effect<Rails>().edge();
        for (const Contact& contact : contacts_) {
            if (contact.kind != Contact::Kind::kRail) continue;
            Vec2& r = run_.balls()[contact.a].r;
            const Vec2 n = outward_normal(contact.rail);
            if (n.x != 0) r.x = n.x * edge.x;
            if (n.y != 0) r.y = n.y * edge.y;
        }
    }

    [[nodiscard]] double restitution() const {
        if constexpr (Set::template kHas<Rails>) return set_.template effect<Rails>().restitution();
        return 1;
    }

    struct FoundCapture {
        std::size_t ball;
        Pocket pocket;
    };

    /// The balls of a contact before its group was resolved.
    struct BeforeContact {
        MovingBall a;
        MovingBall b;
    };

    const Set& set_;
    ShotRun& run_;
    double first_ = 0;
    std::vector<Contact> contacts_;
    std::vector<FoundCapture> captures_;
    std::vector<BeforeContact> before_;
};

}  // namespace poolhall
