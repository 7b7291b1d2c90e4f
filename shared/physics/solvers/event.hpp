#pragma once

#include "shared/physics/cloth.hpp"
#include "shared/physics/shot_run.hpp"
#include "shared/physics/solvers/impacts.hpp"
#include "shared/physics/solvers/own_event_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace poolhall {

/// More events than this at one instant end the shot as stalled (never seen).
inline constexpr int kMaxEventsPerInstant = 10000;

/// No time step: balls move in closed form from event to event, and the next event is the root of
/// an equation. A pair is searched no further than the earlier end of its two arcs.
template <class Set>
class EventSolver {
  public:
    EventSolver(const Set& set, ShotRun& run)
        : set_(set),
          run_(run),
          balls_(run.balls()),
          cloth_(set, run.scene().gravity),
          work_(run.workspace()) {}

    void solve() {
        begin();
        const Outcome outcome = run_events();
        run_.finish(outcome, time(), 0);
    }

  private:
    /// The clock is set back when it shows this, s.
    static constexpr double kEpoch = 1;

    void begin() {
        const std::size_t n = balls_.size();
        work_.arcs.resize(n);
        work_.own.resize(n);
        work_.reach.resize(n);
        work_.pairs.reset(n);
        for (std::size_t i = 0; i < n; ++i) {
            cloth_.settle(balls_[i]);
            launch(i);
        }
        for (std::size_t i = 0; i < n; ++i)
            find_partners(i, i + 1);
    }

    /// What comes next.
    struct Due {
        double t = kNever;
        std::size_t ball = 0;
        bool own = false;       ///< the ball's own event, else its first meeting
        std::size_t count = 0;  ///< how often t was seen: once for an own event, twice for a pair

        [[nodiscard]] bool is_alone() const { return count == (own ? 1U : 2U); }

        void consider(double other, std::size_t i, bool is_own) {
            if (other > t) return;
            count = other < t ? 1 : count + 1;
            if (other == t) return;
            t = other;
            ball = i;
            own = is_own;
        }
    };

    Outcome run_events() {
        const Limits& limits = run_.scene().limits;
        int at_once = 0;
        while (true) {
            const Due due = next_due();
            const double end = limits.time - epoch_;
            if (due.t == kNever && !run_.any_moves()) {
                run_.sample_at(time());
                return Outcome::kRest;
            }
            sample_before(std::min(due.t, end));
            if (run_.event_limit_reached()) return stop_at(now_, Outcome::kEventLimit);
            if (due.t > end) return stop_at(end, Outcome::kTimeLimit);
            at_once = due.t > now_ ? 0 : at_once + 1;
            if (at_once > kMaxEventsPerInstant) return stop_at(now_, Outcome::kStalled);
            now_ = due.t;
            if (!(due.is_alone() ? happen_alone(due) : happen_together()))
                return stop_at(now_, Outcome::kStalled);
            if (now_ >= kEpoch) begin_epoch();
        }
    }

    /// s since the shot's beginning.
    [[nodiscard]] double time() const { return epoch_ + now_; }

    /// Sets the clock back by whole seconds, which are exact: an instant late in a long shot would
    /// be rounded to 1e-11 s, and a million bounces add that up.
    void begin_epoch() {
        const auto passed = static_cast<double>(static_cast<std::int64_t>(now_));
        epoch_ += passed;
        now_ -= passed;
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            work_.arcs[i].since -= passed;
            work_.arcs[i].until -= passed;
            work_.own[i].t -= passed;
        }
        work_.pairs.set_back(passed);
    }

    [[nodiscard]] Due next_due() const {
        Due due;
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            due.consider(work_.own[i].t, i, true);
            due.consider(work_.pairs.first(i), i, false);
        }
        return due;
    }

    void sample_before(double t) {
        while (run_.next_sample() - epoch_ < t) {
            const double at = run_.next_sample() - epoch_;
            run_.sample([&](std::size_t i) {
                const MovingBall& ball = balls_[i];
                if (!in_play(ball) || ball.motion == Motion::kStationary)
                    return Vec3{ball.r.x, ball.r.y, ball.height};
                const Vec2 r = place_on(ball, work_.arcs[i], at);
                return Vec3{r.x, r.y, height_on(ball, work_.arcs[i], at)};
            });
        }
    }

    /// Brings all balls to t, where the shot is cut off.
    Outcome stop_at(double t, Outcome outcome) {
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            if (in_play(balls_[i])) balls_[i] = ball_on(balls_[i], work_.arcs[i], t);
        }
        now_ = t;
        run_.sample_at(time());
        return outcome;
    }

    // --- searching ---------------------------------------------------------------------------

    /// Begins the arc of a settled ball now.
    void launch(std::size_t i) {
        const MovingBall& ball = balls_[i];
        Arc& arc = work_.arcs[i];
        arc = in_play(ball) ? cloth_.arc_of(ball, now_) : Arc{};
        arc.since = now_;
        const Box whole = in_play(ball) ? box_around(ball, arc, arc.until) : Box::nothing();
        OwnEvent& own = work_.own[i];
        own = OwnEventSearch<Set>(set_, ball, arc, whole).find();
        work_.reach.set(i, own.t < arc.until ? box_around(ball, arc, own.t) : whole);
    }

    /// Finds whom ball i, whose arc begins now, meets among those from `from` on.
    void find_partners(std::size_t i, std::size_t from) {
        work_.reach.for_each_overlap(i, from, [&](std::size_t j) {
            const double t = now_ + meeting(i, j);
            if (t < kNever) work_.pairs.set(i, j, t);
        });
    }

    /// In how many s ball i, whose arc begins now, meets ball j, if it is before either's own
    /// event.
    [[nodiscard]] double meeting(std::size_t i, std::size_t j) const {
        const MovingBall& a = balls_[i];
        const MovingBall& b = balls_[j];
        const double horizon = std::min(work_.own[i].t, work_.own[j].t) - now_;
        if constexpr (Set::template kHas<Airborne>) {
            if (a.motion == Motion::kAirborne || b.motion == Motion::kAirborne)
                return meeting_in_air(i, j, horizon);
        }
        const bool a_moves = moves_centre(a.motion);
        const bool b_moves = moves_centre(b.motion);
        if (!a_moves && !b_moves) return kNever;
        const RelativeArc<Vec2> arc = relative_arc(i, j, b_moves);
        const double distance = contact_distance(a, b);
        if (rest_against(i, j, arc, distance)) return kNever;
        const double drag = std::max(work_.arcs[i].drag, work_.arcs[j].drag);
        if (drag > 0) return time_under_drag_until(arc, drag, distance, horizon);
        // Straight on, and slower and slower.
        if ((!b_moves && a.motion == Motion::kRolling) ||
            (!a_moves && b.motion == Motion::kRolling))
            return first_contact_straight(arc.c, arc.v, norm(arc.a), distance, horizon);
        return first_contact(arc, distance, horizon);
    }

    /// Ball j as seen from ball i now.
    [[nodiscard]] RelativeArc<Vec2> relative_arc(std::size_t i, std::size_t j, bool j_moves) const {
        const MovingBall& a = balls_[i];
        const MovingBall& b = balls_[j];
        const Arc& other = work_.arcs[j];
        if (!j_moves) return {b.r - a.r, -a.v, -work_.arcs[i].a};
        return {place_on(b, other, now_) - a.r, velocity_on(b, other, now_) - a.v,
                other.a - work_.arcs[i].a};
    }

    /// Under drag all balls move uniformly on a clock that they share.
    [[nodiscard]] static double time_under_drag_until(const RelativeArc<Vec2>& arc, double drag,
                                                      double distance, double horizon) {
        const double t =
            time_under_drag(drag, first_contact_straight(arc.c, arc.v, 0, distance, kNever));
        return t <= horizon ? t : kNever;
    }

    [[nodiscard]] double meeting_in_air(std::size_t i, std::size_t j, double horizon) const {
        const MovingBall a = ball_on(balls_[i], work_.arcs[i], now_);
        const MovingBall b = ball_on(balls_[j], work_.arcs[j], now_);
        const double rise = (b.radius + b.height) - (a.radius + a.height);
        const Vec2 c = b.r - a.r;
        const Vec2 v = b.v - a.v;
        const Vec2 acceleration = work_.arcs[j].a - work_.arcs[i].a;
        return first_contact(RelativeArc<Vec3>{{c.x, c.y, rise},
                                               {v.x, v.y, b.climb - a.climb},
                                               {acceleration.x, acceleration.y,
                                                work_.arcs[i].gravity - work_.arcs[j].gravity}},
                             a.radius + b.radius, horizon);
    }

    /// True for balls that touch, are not pressed together, and approach no more than rounding
    /// makes them: partners of an impact without friction, balls between dead rails.
    [[nodiscard]] bool rest_against(std::size_t i, std::size_t j, const RelativeArc<Vec2>& arc,
                                    double distance) const {
        constexpr double kRounding = 0x1p-48;
        if (arc.a == Vec2{} && balls_[i].partner == j && balls_[j].partner == i) return true;
        if (dot(arc.c, arc.c) > (1 + kRounding) * distance * distance) return false;
        if (dot(arc.c, arc.a) < 0) return false;
        const double speed = norm(balls_[i].v) + norm(balls_[j].v);
        return -dot(arc.c, arc.v) <= kRounding * distance * speed;
    }

    // --- letting it happen -------------------------------------------------------------------

    /// The ordinary case: one thing at a time. False if it does not settle.
    bool happen_alone(const Due& due) {
        work_.contacts.clear();
        if (!due.own) {
            const std::size_t other = work_.pairs.partner(due.ball);
            work_.contacts.push_back(
                ball_contact(std::min(due.ball, other), std::max(due.ball, other)));
            return collide();
        }
        switch (work_.own[due.ball].kind) {
            case OwnEvent::Kind::kTransition:
                transition(due.ball);
                return true;
            case OwnEvent::Kind::kCapture:
                capture(due.ball);
                return true;
            case OwnEvent::Kind::kRail:
                add_rails(due.ball);
                return collide();
        }
        return false;
    }

    /// Several things at one instant: transitions, or else captures, or else the contacts as one
    /// group; what is left comes up again.
    bool happen_together() {
        if (for_each_own(OwnEvent::Kind::kTransition, [this](std::size_t i) { transition(i); }))
            return true;
        if (for_each_own(OwnEvent::Kind::kCapture, [this](std::size_t i) { capture(i); }))
            return true;
        work_.contacts.clear();
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            if (work_.pairs.first(i) == now_) add_pairs(i);
        }
        for_each_own(OwnEvent::Kind::kRail, [this](std::size_t i) { add_rails(i); });
        return collide();
    }

    template <class Do>
    bool for_each_own(OwnEvent::Kind kind, Do act) {
        bool any = false;
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            if (work_.own[i].t != now_ || work_.own[i].kind != kind) continue;
            any = true;
            act(i);
        }
        return any;
    }

    void transition(std::size_t i) {
        cloth_.transition(balls_[i], work_.arcs[i], [&](EventKind kind, const MovingBall& before) {
            run_.record(time(), kind, i, before);
        });
        refresh(i);
    }

    void capture(std::size_t i) {
        balls_[i] = ball_on(balls_[i], work_.arcs[i], now_);
        run_.capture(time(), i, work_.own[i].pocket);
        refresh(i);
    }

    void refresh(std::size_t i) {
        launch(i);
        renew_partners(i);
    }

    void renew_partners(std::size_t i) {
        work_.pairs.forget(i);
        find_partners(i, 0);
    }

    void add_pairs(std::size_t i) {
        work_.pairs.for_each_partner(i, [&](std::size_t j, double t) {
            if (j > i && t == now_) work_.contacts.push_back(ball_contact(i, j));
        });
    }

    void add_rails(std::size_t i) {
        const OwnEvent& own = work_.own[i];
        for (std::size_t k = 0; k < own.touch_count; ++k) {
            work_.contacts.push_back(
                {Contact::Kind::kRail, i, i, own.touches[k].rail, own.touches[k].normal});
        }
    }

    bool collide() {
        for (const Contact& contact : work_.contacts) {
            for (const std::size_t i : {contact.a, contact.b})
                bring_to_now(i);
        }
        if (!resolve_contacts(set_, cloth_, run_, time())) return false;
        // All arcs first: a search looks at both.
        for (const Contact& contact : work_.contacts) {
            launch(contact.a);
            if (contact.b != contact.a) launch(contact.b);
        }
        for (const Contact& contact : work_.contacts) {
            renew_partners(contact.a);
            if (contact.b != contact.a) renew_partners(contact.b);
        }
        return true;
    }

    void bring_to_now(std::size_t i) {
        if (work_.arcs[i].since == now_) return;
        balls_[i] = ball_on(balls_[i], work_.arcs[i], now_);
        work_.arcs[i].since = now_;
    }

    const Set& set_;
    ShotRun& run_;
    std::vector<MovingBall>& balls_;
    Cloth<Set> cloth_;
    Workspace& work_;
    double epoch_ = 0;  ///< whole s since the shot's beginning, at which the clock was 0
    double now_ = 0;    ///< the clock, s; so are all times in the workspace
};

}  // namespace poolhall
