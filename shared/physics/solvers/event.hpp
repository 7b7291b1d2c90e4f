#pragma once

#include "shared/physics/motion/cloth.hpp"
#include "shared/physics/solvers/event_memory.hpp"
#include "shared/physics/solvers/impacts.hpp"
#include "shared/physics/solvers/own_event_search.hpp"
#include "shared/physics/solvers/shot_run.hpp"

#include <algorithm>
#include <cstdint>

namespace poolhall {

/// More events than this at one instant end the shot as stalled (never seen).
inline constexpr int kMaxEventsPerInstant = 10000;

/// No time step: balls move in closed form from event to event, and the next event is the root of
/// an equation. A pair is searched no further than the earlier end of its two arcs.
template <class Set>
class EventSolver {
  public:
    EventSolver(const Set& set, ShotRun& run, EventMemory& memory)
        : set_(set),
          run_(run),
          balls_(run.balls()),
          cloth_(set, run.scene().gravity),
          memory_(memory),
          contacts_(run.workspace().contacts) {}

    void solve() {
        begin();
        const Outcome outcome = run_events();
        run_.finish(outcome, time(), 0);
    }

  private:
    /// The clock is set back when it shows this, s.
    static constexpr Real kEpoch = 1;

    void begin() {
        const std::size_t n = balls_.size();
        memory_.arcs.resize(n);
        memory_.own.resize(n);
        memory_.courses.resize(n);
        memory_.due.reset(n, run_.workspace().many_balls);
        memory_.reach.reset(n, room(), run_.workspace().many_balls);
        memory_.pairs.reset(n);
        for (std::size_t i = 0; i < n; ++i) {
            cloth_.settle(balls_[i]);
            launch(i);
        }
        for (std::size_t i = 0; i < n; ++i)
            find_partners(i, i + 1);
    }

    /// Where the balls stay; more or less, on an endless cloth.
    [[nodiscard]] Box room() const {
        const Table& table = run_.scene().table;
        return {-table.length / 2, table.length / 2, -table.width / 2, table.width / 2};
    }

    Outcome run_events() {
        const Limits& limits = run_.scene().limits;
        int at_once = 0;
        while (true) {
            const Soonest::Found due = memory_.due.find();
            const Real end = limits.time - epoch_;
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
            if (!happen(due)) return stop_at(now_, Outcome::kStalled);
            if (now_ >= kEpoch) begin_epoch();
        }
    }

    /// s since the shot's beginning.
    [[nodiscard]] Real time() const { return epoch_ + now_; }

    /// Sets the clock back by whole seconds, which are exact: an instant late in a long shot would
    /// be rounded to 1e-11 s, and a million bounces add that up.
    void begin_epoch() {
        const auto passed = static_cast<Real>(static_cast<std::int64_t>(now_));
        epoch_ += passed;
        now_ -= passed;
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            memory_.arcs[i].since -= passed;
            memory_.arcs[i].until -= passed;
            memory_.own[i].t -= passed;
            memory_.courses[i].since -= passed;
            memory_.courses[i].until -= passed;
        }
        memory_.pairs.set_back(passed);
        for (std::size_t i = 0; i < balls_.size(); ++i)
            plan(i);
    }

    void sample_before(Real t) {
        while (run_.next_sample() - epoch_ < t) {
            const Real at = run_.next_sample() - epoch_;
            run_.sample([&](std::size_t i) {
                const MovingBall& ball = balls_[i];
                if (!in_play(ball) || ball.motion == Motion::kStationary)
                    return Vec3{ball.r.x, ball.r.y, ball.height};
                const Vec2 r = place_on(ball, memory_.arcs[i], at);
                return Vec3{r.x, r.y, height_on(ball, memory_.arcs[i], at)};
            });
        }
    }

    /// Brings all balls to t, where the shot is cut off.
    Outcome stop_at(Real t, Outcome outcome) {
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            if (in_play(balls_[i])) advance(balls_[i], memory_.arcs[i], t);
        }
        now_ = t;
        run_.sample_at(time());
        return outcome;
    }

    // --- searching ---------------------------------------------------------------------------

    /// Begins the arc of a settled ball now.
    void launch(std::size_t i) {
        const MovingBall& ball = balls_[i];
        Arc& arc = memory_.arcs[i];
        OwnEvent& own = memory_.own[i];
        if (!in_play(ball)) {
            arc = {};
            own = {};
            memory_.reach.remove(i);
            return;
        }
        cloth_.find_arc(ball, now_, arc);
        OwnEventSearch<Set> search(set_, ball, arc, own);
        search.find();
        memory_.courses[i].set(ball, arc, own.t);
        memory_.reach.set(i, search.reach());
    }

    /// Finds whom ball i, whose arc begins now, meets among those from `from` on.
    void find_partners(std::size_t i, std::size_t from) {
        const Course& course = memory_.courses[i];
        memory_.reach.for_each_overlap(i, from, [&](std::size_t j) {
            if (!may_meet(course, memory_.courses[j], now_)) return;
            const Real t = now_ + meeting(i, j);
            if (t == kNever) return;
            memory_.pairs.set(i, j, t);
            plan(j);
        });
        plan(i);
    }

    /// Notes when something happens to the ball next.
    void plan(std::size_t i) {
        memory_.due.set(i, std::min(memory_.own[i].t, memory_.pairs.first(i)));
    }

    /// In how many s ball i, whose arc begins now, meets ball j, if it is before either's own
    /// event.
    [[nodiscard]] Real meeting(std::size_t i, std::size_t j) const {
        const MovingBall& a = balls_[i];
        const MovingBall& b = balls_[j];
        const Real horizon = std::min(memory_.own[i].t, memory_.own[j].t) - now_;
        if constexpr (Set::template kHook<hooks::Flight>) {
            if (a.motion == Motion::kAirborne || b.motion == Motion::kAirborne)
                return meeting_in_air(i, j, horizon);
        }
        const bool a_moves = moves_centre(a.motion);
        const bool b_moves = moves_centre(b.motion);
        if (!a_moves && !b_moves) return kNever;
        const RelativeArc<Vec2> arc = relative_arc(i, j, b_moves);
        const Real distance = contact_distance(a, b);
        if (rest_against(i, j, arc, distance)) return kNever;
        const Real drag = std::max(memory_.arcs[i].drag, memory_.arcs[j].drag);
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
        const Arc& other = memory_.arcs[j];
        if (!j_moves) return {b.r - a.r, -a.v, -memory_.arcs[i].a};
        return {place_on(b, other, now_) - a.r, velocity_on(b, other, now_) - a.v,
                other.a - memory_.arcs[i].a};
    }

    /// Under drag all balls move uniformly on a clock that they share.
    [[nodiscard]] static Real time_under_drag_until(const RelativeArc<Vec2>& arc, Real drag,
                                                    Real distance, Real horizon) {
        const Real t =
            time_under_drag(drag, first_contact_straight(arc.c, arc.v, 0, distance, kNever));
        return t <= horizon ? t : kNever;
    }

    [[nodiscard]] Real meeting_in_air(std::size_t i, std::size_t j, Real horizon) const {
        const MovingBall a = ball_on(balls_[i], memory_.arcs[i], now_);
        const MovingBall b = ball_on(balls_[j], memory_.arcs[j], now_);
        const Real rise = (b.radius + b.height) - (a.radius + a.height);
        const Vec2 c = b.r - a.r;
        const Vec2 v = b.v - a.v;
        const Vec2 acceleration = memory_.arcs[j].a - memory_.arcs[i].a;
        const RelativeArc<Vec3> arc{
            {c.x, c.y, rise},
            {v.x, v.y, b.climb - a.climb},
            {acceleration.x, acceleration.y, memory_.arcs[i].gravity - memory_.arcs[j].gravity}};
        const Real distance = a.radius + b.radius;
        return first_contact(arc, distance, horizon);
    }

    /// True for balls that touch, are not pressed together, and approach no more than rounding
    /// makes them: partners of an impact without friction, balls between dead rails.
    [[nodiscard]] bool rest_against(std::size_t i, std::size_t j, const RelativeArc<Vec2>& arc,
                                    Real distance) const {
        if (arc.a == Vec2{} && balls_[i].partner == j && balls_[j].partner == i) return true;
        if (dot(arc.c, arc.c) > (1 + kTouchRounding) * distance * distance) return false;
        if (dot(arc.c, arc.a) < 0) return false;
        const Real speed = norm(balls_[i].v) + norm(balls_[j].v);
        return -dot(arc.c, arc.v) <= kTouchRounding * distance * speed;
    }

    // --- letting it happen -------------------------------------------------------------------

    /// False if it does not settle.
    bool happen(const Soonest::Found& due) {
        if (due.count == 1) return happen_alone(due.ball);
        const std::size_t other = memory_.pairs.partner(due.ball);
        const bool is_pair =
            due.count == 2 && memory_.own[due.ball].t > now_ && memory_.own[other].t > now_;
        return is_pair ? meet_alone(due.ball, other) : happen_together();
    }

    /// The ordinary case: one thing at a time.
    bool happen_alone(std::size_t i) {
        switch (memory_.own[i].kind) {
            case OwnEvent::Kind::kTransition:
                transition(i);
                return true;
            case OwnEvent::Kind::kCapture:
                capture(i);
                return true;
            case OwnEvent::Kind::kRail:
                contacts_.clear();
                add_rails(i);
                return collide();
        }
        return false;
    }

    bool meet_alone(std::size_t i, std::size_t j) {
        contacts_.clear();
        contacts_.push_back(ball_contact(std::min(i, j), std::max(i, j)));
        return collide();
    }

    /// Several things at one instant: transitions, or else captures, or else the contacts as one
    /// group; what is left comes up again.
    bool happen_together() {
        if (for_each_own(OwnEvent::Kind::kTransition, [this](std::size_t i) { transition(i); }))
            return true;
        if (for_each_own(OwnEvent::Kind::kCapture, [this](std::size_t i) { capture(i); }))
            return true;
        contacts_.clear();
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            if (memory_.pairs.first(i) == now_) add_pairs(i);
        }
        for_each_own(OwnEvent::Kind::kRail, [this](std::size_t i) { add_rails(i); });
        return collide();
    }

    template <class Do>
    bool for_each_own(OwnEvent::Kind kind, Do act) {
        bool any = false;
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            if (memory_.own[i].t != now_ || memory_.own[i].kind != kind) continue;
            any = true;
            act(i);
        }
        return any;
    }

    void transition(std::size_t i) {
        cloth_.transition(balls_[i], memory_.arcs[i],
                          [&](EventKind kind, const MovingBall& before) {
                              run_.record(time(), kind, i, before);
                          });
        refresh(i);
    }

    void capture(std::size_t i) {
        advance(balls_[i], memory_.arcs[i], now_);
        run_.capture(time(), i, memory_.own[i].pocket);
        refresh(i);
    }

    void refresh(std::size_t i) {
        launch(i);
        renew_partners(i);
    }

    void renew_partners(std::size_t i) {
        memory_.pairs.forget(i, [this](std::size_t j) { plan(j); });
        find_partners(i, 0);
    }

    void add_pairs(std::size_t i) {
        memory_.pairs.for_each_partner(i, [&](std::size_t j, Real t) {
            if (j > i && t == now_) contacts_.push_back(ball_contact(i, j));
        });
    }

    void add_rails(std::size_t i) {
        const OwnEvent& own = memory_.own[i];
        for (std::size_t k = 0; k < own.touch_count; ++k) {
            contacts_.push_back(
                {Contact::Kind::kRail, i, i, own.touches[k].rail, own.touches[k].normal});
        }
    }

    bool collide() {
        for (const Contact& contact : contacts_) {
            for (const std::size_t i : {contact.a, contact.b})
                bring_to_now(i);
        }
        lose_balls_over_rails(set_, run_, time());
        if constexpr (Set::template kHook<hooks::Flight>) {
            for (const Contact& contact : contacts_) {
                if (!in_play(balls_[contact.a])) refresh(contact.a);
            }
        }
        if (!resolve_contacts(set_, cloth_, run_, time())) return false;
        // All arcs first: a search looks at both.
        for (const Contact& contact : contacts_) {
            launch(contact.a);
            if (contact.b != contact.a) launch(contact.b);
        }
        for (const Contact& contact : contacts_) {
            renew_partners(contact.a);
            if (contact.b != contact.a) renew_partners(contact.b);
        }
        return true;
    }

    void bring_to_now(std::size_t i) {
        if (memory_.arcs[i].since == now_) return;
        advance(balls_[i], memory_.arcs[i], now_);
        memory_.arcs[i].since = now_;
    }

    const Set& set_;
    ShotRun& run_;
    std::vector<MovingBall>& balls_;
    Cloth<Set> cloth_;
    EventMemory& memory_;
    std::vector<Contact>& contacts_;
    Real epoch_ = 0;  ///< whole s since the shot's beginning, at which the clock was 0
    Real now_ = 0;    ///< the clock, s; so are all times in the memory
};

}  // namespace poolhall
