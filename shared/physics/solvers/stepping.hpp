#pragma once

#include "shared/physics/cloth.hpp"
#include "shared/physics/contact_time.hpp"
#include "shared/physics/effects/effect_set.hpp"
#include "shared/physics/effects/pool_mouths.hpp"
#include "shared/physics/effects/rails.hpp"
#include "shared/physics/shot_run.hpp"
#include "shared/physics/solvers/impacts.hpp"
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

/// Runs `tick(begin, end)` (s) at the scene's rate until nothing moves or a limit is reached. A
/// tick answers kRest when it went well, and otherwise how the shot ends. Times are k / hz, not a
/// sum, so that rates agree on the instants they share.
template <class Tick>
void run_ticks(ShotRun& run, Tick tick) {
    const double hz = run.scene().solver.hz;
    const double limit = run.scene().limits.time;
    std::uint64_t ticks = 0;
    double t = 0;
    run.sample_at(0);
    Outcome outcome = Outcome::kRest;
    while (outcome == Outcome::kRest && run.any_moves()) {
        if (run.event_limit_reached()) {
            outcome = Outcome::kEventLimit;
        } else if (t >= limit) {
            outcome = Outcome::kTimeLimit;
        } else {
            const double end = std::min(static_cast<double>(ticks + 1) / hz, limit);
            outcome = tick(t, end);
            t = end;
            ++ticks;
        }
    }
    run.finish(outcome, t, ticks);
}

/// When the velocities change in a tick.
enum class Scheme {
    kEuler,         ///< after the places
    kSemiImplicit,  ///< before the places
    kExactArc,      ///< all along: closed-form motion, contacts on the chords of the arcs
};

/// Ticks of 1 / hz. Within one, motion is taken as uniform (for arcs: from where the ball is to
/// where its arc leads), so contacts are found by their time of impact, earliest first, as many as
/// there are: nothing tunnels at any speed.
template <class Set, Scheme kScheme>
class SteppingSolver {
  public:
    SteppingSolver(const Set& set, ShotRun& run)
        : set_(set),
          run_(run),
          balls_(run.balls()),
          cloth_(set, run.scene().gravity),
          work_(run.workspace()) {}

    void solve() {
        work_.boxes.resize(balls_.size());
        for (MovingBall& ball : balls_)
            cloth_.settle(ball);
        if constexpr (kScheme == Scheme::kExactArc) launch_all();
        run_ticks(run_, [this](double begin, double end) { return tick(begin, end); });
    }

  private:
    /// One tick from `begin` to `end`, in s. kRest means that it went well.
    Outcome tick(double begin, double end) {
        const double dt = end - begin;
        double passed = 0;
        if constexpr (kScheme == Scheme::kSemiImplicit) kick_all(dt, begin);
        if constexpr (kScheme == Scheme::kExactArc) aim_chords(begin, end);
        for (int round = 0; round < kMaxContactsPerTick; ++round) {
            if (run_.event_limit_reached()) return Outcome::kEventLimit;
            const double rest = std::max(dt - passed, 0.0);
            now_ = begin + passed;
            const double next = next_instant(rest);
            if (next > rest) {
                advance(begin + passed, end, rest);
                if constexpr (kScheme == Scheme::kEuler) kick_all(dt, end);
                if constexpr (kScheme == Scheme::kExactArc) arrive(end);
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

    /// The velocity with which ball i is taken to move within this tick.
    [[nodiscard]] Vec3 drift(std::size_t i) const {
        const MovingBall& ball = balls_[i];
        if constexpr (kScheme == Scheme::kExactArc)
            return moves_centre(ball.motion) ? work_.drift[i] : Vec3{};
        return {ball.v.x, ball.v.y, ball.motion == Motion::kAirborne ? ball.climb : 0};
    }

    void advance(double from, double tick_end, double time) {
        const double until = std::min(from + time, tick_end);
        while (run_.next_sample() < until) {
            const double passed = run_.next_sample() - from;
            run_.sample([&](std::size_t i) { return place_after(i, passed); });
        }
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            const Vec3 place = place_after(i, time);
            balls_[i].r = xy(place);
            balls_[i].height = place.z;
        }
    }

    [[nodiscard]] Vec3 place_after(std::size_t i, double time) const {
        const MovingBall& ball = balls_[i];
        const Vec3 way = time * drift(i);
        const Vec2 r = ball.r + xy(way);
        if constexpr (Set::template kHas<Airborne>) return {r.x, r.y, ball.height + way.z};
        return {r.x, r.y, ball.height};
    }

    void kick_all(double dt, double t) {
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            MovingBall& ball = balls_[i];
            if (ball.motion == Motion::kStationary) continue;
            cloth_.kick(ball, dt, [&](EventKind kind, const MovingBall& before) {
                run_.record(t, kind, i, before);
            });
            // Friction may turn two balls towards each other again.
            if constexpr (Set::template kHas<Sliding>) ball.partner = MovingBall::kNobody;
        }
    }

    // --- exact arcs --------------------------------------------------------------------------

    void launch_all() {
        work_.arcs.resize(balls_.size());
        work_.launched.resize(balls_.size());
        work_.drift.resize(balls_.size());
        for (std::size_t i = 0; i < balls_.size(); ++i)
            launch(i, 0);
    }

    void launch(std::size_t i, double t) {
        work_.launched[i] = balls_[i];
        work_.arcs[i] = cloth_.arc_of(balls_[i], t);
        aim_chord(i, t);
    }

    void aim_chords(double begin, double end) {
        tick_end_ = end;
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            aim_chord(i, begin);
            // Friction may have turned two balls towards each other again.
            if constexpr (Set::template kHas<Sliding>) balls_[i].partner = MovingBall::kNobody;
        }
    }

    /// Takes the chord of ball i from where it is on its arc at `from` to the tick's end, or
    /// earlier where its motion changes. It is the mean velocity: as a difference of places it
    /// would be nothing but rounding when the time is short.
    void aim_chord(std::size_t i, double from) {
        work_.drift[i] = {};
        const MovingBall& ball = work_.launched[i];
        const Arc& arc = work_.arcs[i];
        const double to = std::min(tick_end_, arc.until);
        if (to <= from) return;
        if (arc.drag > 0) {
            const double way = way_under_drag(arc.drag, to - from) / (to - from);
            const Vec2 v = way * velocity_on(ball, arc, from);
            work_.drift[i] = {v.x, v.y, 0};
            return;
        }
        const double middle = (from - arc.since) / 2 + (to - arc.since) / 2;
        const Vec2 v = ball.v + middle * arc.a;
        work_.drift[i] = {v.x, v.y, ball.climb - middle * arc.gravity};
    }

    /// Every ball at `t` as its arc has it.
    void arrive(double t) {
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            const Vec2 r = balls_[i].r;
            update_from_arc(i, t);
            // Straight on, the way within a tick is more exact than that since the last event.
            if (work_.arcs[i].a == Vec2{} && work_.arcs[i].drag == 0) balls_[i].r = r;
        }
    }

    void update_from_arc(std::size_t i, double t) {
        if (balls_[i].motion == Motion::kStationary || !in_play(balls_[i])) return;
        const std::size_t partner = balls_[i].partner;
        balls_[i] = ball_on(work_.launched[i], work_.arcs[i], t);
        balls_[i].partner = partner;
    }

    // --- what happens first ------------------------------------------------------------------

    /// Collects what happens first within `time` s, and returns when; more than `time` if nothing
    /// does.
    double next_instant(double time) {
        forget();
        first_ = next_above(time);
        if constexpr (kScheme == Scheme::kExactArc) find_transitions(time);
        find_captures(time);
        find_ball_contacts(time);
        find_rail_contacts(time);
        return first_;
    }

    void forget() {
        work_.contacts.clear();
        work_.captures.clear();
        work_.transitions.clear();
    }

    /// True if an event at t is among the first; forgets later ones.
    bool is_first(double t) {
        if (t > first_) return false;
        if (t < first_) forget();
        first_ = t;
        return true;
    }

    void find_transitions(double time) {
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            if (!in_play(balls_[i])) continue;
            const double t = std::max(work_.arcs[i].until - now_, 0.0);
            if (t <= time && is_first(t)) work_.transitions.push_back(i);
        }
    }

    void find_captures(double time) {
        set_.for_each([&]<PocketEffect Pockets>(const Pockets& pockets) {
            for (std::size_t i = 0; i < balls_.size(); ++i) {
                if (!is_on_cloth(balls_[i].motion)) continue;
                const Vec2 way = xy(drift(i));
                if (way == Vec2{}) continue;
                const std::optional<Capture> capture =
                    pockets.first_capture(balls_[i].r, way, time);
                if (capture && is_first(capture->t)) work_.captures.push_back({i, capture->pocket});
            }
        });
    }

    void find_ball_contacts(double time) {
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            if (in_play(balls_[i])) {
                work_.boxes.set(i, balls_[i].r, time * xy(drift(i)), balls_[i].radius);
            } else {
                work_.boxes.remove(i);
            }
        }
        work_.boxes.for_each_pair([&](std::size_t a, std::size_t b) { find_ball_contact(a, b); });
    }

    void find_ball_contact(std::size_t i, std::size_t j) {
        const MovingBall& a = balls_[i];
        const MovingBall& b = balls_[j];
        const Vec3 v_a = drift(i);
        const Vec3 v_b = drift(j);
        if (v_a == v_b || (a.partner == j && b.partner == i)) return;
        const double t = meeting(i, j);
        if (t == kNever || rest_against(i, j)) return;
        if (is_first(t)) work_.contacts.push_back(ball_contact(i, j));
    }

    [[nodiscard]] double meeting(std::size_t i, std::size_t j) const {
        const MovingBall& a = balls_[i];
        const MovingBall& b = balls_[j];
        const Vec3 v_a = drift(i);
        const Vec3 v_b = drift(j);
        if constexpr (Set::template kHas<Airborne>) {
            const double rise = b.height - a.height;
            if (rise != 0 || v_a.z != v_b.z) {
                const Vec2 c = b.r - a.r;
                return straight_contact({c.x, c.y, rise + (b.radius - a.radius)}, v_b - v_a,
                                        a.radius + b.radius);
            }
        }
        return time_of_impact({a.r, xy(v_a)}, {b.r, xy(v_b)}, contact_distance(a, b))
            .value_or(kNever);
    }

    /// True for balls that touch and approach no more than rounding makes them. An impact would
    /// only hand that rounding to and fro between them and what holds them, without end; left alone
    /// it makes an overlap far below kTouchTolerance.
    [[nodiscard]] bool rest_against(std::size_t i, std::size_t j) const {
        constexpr double kRounding = 0x1p-48;
        const MovingBall& a = balls_[i];
        const MovingBall& b = balls_[j];
        const double distance = contact_distance(a, b);
        const Vec2 c = b.r - a.r;
        const Vec2 v_a = xy(drift(i));
        const Vec2 v_b = xy(drift(j));
        const double speed =
            std::max({std::abs(v_a.x), std::abs(v_a.y), std::abs(v_b.x), std::abs(v_b.y)});
        return dot(c, c) <= (1 + kRounding) * distance * distance &&
               -dot(c, v_b - v_a) <= kRounding * distance * speed;
    }

    void find_rail_contacts(double time) {
        if constexpr (Set::template kHas<Rails>) {
            const Rails& rails = set_.template effect<Rails>();
            for (std::size_t i = 0; i < balls_.size(); ++i) {
                const Vec2 v = xy(drift(i));
                if (!in_play(balls_[i]) || !rails.may_reach(balls_[i], v, time)) continue;
                for (const auto& hit :
                     {rails.next_short_rail(balls_[i], v), rails.next_long_rail(balls_[i], v)}) {
                    if (hit && is_first(hit->t))
                        work_.contacts.push_back(rail_contact(i, hit->rail));
                }
            }
        }
        if constexpr (Set::template kHas<PoolMouths>) {
            const PoolMouths& mouths = set_.template effect<PoolMouths>();
            for (std::size_t i = 0; i < balls_.size(); ++i) {
                const Vec2 v = xy(drift(i));
                if (!in_play(balls_[i]) || v == Vec2{} || !mouths.may_reach(balls_[i], v, time))
                    continue;
                if (const auto hit = mouths.straight_hit(balls_[i], v); hit && is_first(hit->t)) {
                    work_.contacts.push_back({Contact::Kind::kRail, i, i, hit->rail, hit->normal});
                }
            }
        }
    }

    // --- letting it happen -------------------------------------------------------------------

    /// Lets happen what next_instant() found: transitions, or else captures, or else the contacts
    /// as one group. What is left is found again, 0 s from here.
    bool happen(double t) {
        for (const std::size_t i : work_.transitions)
            change_motion(i, t);
        if (!work_.transitions.empty()) return true;
        for (const auto& [ball, pocket] : work_.captures)
            run_.capture(t, ball, pocket);
        if (!work_.captures.empty()) return true;
        return collide(t);
    }

    void change_motion(std::size_t i, double t) {
        balls_[i] = work_.launched[i];
        cloth_.transition(balls_[i], work_.arcs[i], [&](EventKind kind, const MovingBall& before) {
            run_.record(t, kind, i, before);
        });
        launch(i, t);
    }

    bool collide(double t) {
        for (const Contact& contact : work_.contacts) {
            prepare_for_impact(contact.a, t);
            prepare_for_impact(contact.b, t);
        }
        if (!resolve_contacts(set_, cloth_, run_, t)) return false;
        if constexpr (kScheme == Scheme::kExactArc) {
            for (const Contact& contact : work_.contacts) {
                launch(contact.a, t);
                launch(contact.b, t);
            }
        }
        return true;
    }

    /// Velocities and spins as they are at t; places stay on the chord, where the contact was
    /// found.
    void prepare_for_impact(std::size_t i, double t) {
        if constexpr (kScheme == Scheme::kExactArc) {
            const Vec2 r = balls_[i].r;
            update_from_arc(i, t);
            balls_[i].r = r;
        } else {
            cloth_.update_spin(balls_[i]);
        }
    }

    const Set& set_;
    ShotRun& run_;
    std::vector<MovingBall>& balls_;
    Cloth<Set> cloth_;
    Workspace& work_;
    double first_ = 0;
    double now_ = 0;       ///< s; how far the tick has come
    double tick_end_ = 0;  ///< s
};

}  // namespace poolhall
