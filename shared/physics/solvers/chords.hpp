#pragma once

#include "shared/physics/contact/contact.hpp"
#include "shared/physics/motion/arc.hpp"
#include "shared/physics/solvers/exact_arc_memory.hpp"

#include <algorithm>
#include <vector>

namespace poolhall {

/// The chords of the balls' arcs, on which contacts are looked for. A chord leads from where a
/// ball is to where its arc leads at the tick's end, or earlier: where the arc ends, or where
/// renew() says.
class Chords {
  public:
    Chords(const std::vector<MovingBall>& balls, ExactArcMemory& memory)
        : balls_(balls), memory_(memory), chords_(memory.chords) {}

    void begin_shot() {
        memory_.arcs.resize(balls_.size());
        memory_.launched.resize(balls_.size());
        chords_.assign(balls_.size(), {});
        tick_end_ = 0;
    }

    /// `moving` has every ball that is not at rest; the others have no need of a chord.
    void begin_tick(Real begin, Real end, const BallList& moving) {
        tick_end_ = end;
        for (const std::size_t i : moving)
            aim(i, begin);
    }

    /// From where ball i is on its arc at `from` (s) on, as far as it goes in this tick.
    void aim(std::size_t i, Real from) {
        chords_[i].from = from;
        end_at(i, std::min(tick_end_, memory_.arcs[i].until));
    }

    /// From where ball i is now on, up to `end` (s) at most. Its arc is moved to there: by less
    /// than a chord's height, an error of second order.
    void renew(std::size_t i, Real now, Real end) {
        if (!moves_centre(balls_[i].motion)) return;
        Chord& chord = chords_[i];
        if (chord.from != now) {
            MovingBall& launched = memory_.launched[i];
            const MovingBall& ball = balls_[i];
            launched.r = launched.r + (ball.r - place_on(launched, memory_.arcs[i], now));
            launched.height += ball.height - height_on(launched, memory_.arcs[i], now);
            chord.from = now;
        }
        end_at(i, std::min(chord.to, end));
    }

    /// m/s
    [[nodiscard]] Vec3 drift(std::size_t i) const {
        return moves_centre(balls_[i].motion) ? chords_[i].v : Vec3{};
    }

    /// How long from `now` (s) until a chord that ends before the tick does; kNever for another.
    [[nodiscard]] Real ends_within_tick(std::size_t i, Real now) const {
        const Chord& chord = chords_[i];
        if (chord.to >= tick_end_ && chord.to < memory_.arcs[i].until) return kNever;
        return std::max(chord.to - now, Real{0});
    }

    [[nodiscard]] bool ends_with_arc(std::size_t i) const {
        return chords_[i].to >= memory_.arcs[i].until;
    }

    /// True for balls that cannot meet: they fly apart, and so do their chords.
    [[nodiscard]] bool have_parted(std::size_t a, std::size_t b) const {
        return fly_apart(a, b) && cover_the_same_time(a, b);
    }

    /// For a contact of chords t s from `now` (s) at which the bodies do not approach by their
    /// arcs: up to when chords that begin now may go, so that they do not lead through each other.
    /// kNever for a true contact.
    [[nodiscard]] Real end_of_false_contact(const Contact& contact, Real now, Real t) const {
        const Vec3 n = towards(contact, t);
        const Real approach = approach_of(contact, n, now + t);
        if (approach > 0 && !fly_apart(contact.a, contact.b)) return kNever;
        const Real end = std::min(end_of(contact.a), end_of(contact.b));
        // What chords of different stretches of time say of each other means little.
        if (!begins_at(contact.a, now) || !begins_at(contact.b, now) ||
            !cover_the_same_time(contact.a, contact.b))
            return end;
        // Approach is linear in time, and positive in the middle of the chords: it has a root
        // between that and t.
        const Real root = now + (t - approach / growth_of(contact, n));
        return root > now + kShortest && root < end ? root : kNever;
    }

  private:
    /// What parts so slowly that it would come back sooner than this (s) counts as pressed
    /// together, and is parted as an impact (SlowImpacts in contact.hpp).
    static constexpr Real kShortest = 1e-9;

    /// When the chord ends, s; a ball that stays where it is has no need of one.
    [[nodiscard]] Real end_of(std::size_t i) const {
        return moves_centre(balls_[i].motion) ? chords_[i].to : tick_end_;
    }

    [[nodiscard]] bool begins_at(std::size_t i, Real t) const {
        return !moves_centre(balls_[i].motion) || chords_[i].from == t;
    }

    [[nodiscard]] bool cover_the_same_time(std::size_t a, std::size_t b) const {
        return !moves_centre(balls_[a].motion) || !moves_centre(balls_[b].motion) ||
               (chords_[a].from == chords_[b].from && chords_[a].to == chords_[b].to);
    }

    /// After an impact, and without an acceleration that could bring them together again.
    [[nodiscard]] bool fly_apart(std::size_t a, std::size_t b) const {
        return balls_[a].partner == b && balls_[b].partner == a &&
               memory_.arcs[a].a == memory_.arcs[b].a &&
               memory_.arcs[a].gravity == memory_.arcs[b].gravity;
    }

    /// The chord's velocity is the mean velocity: as a difference of places it would be nothing but
    /// rounding when the time is short.
    void end_at(std::size_t i, Real to) {
        Chord& chord = chords_[i];
        chord.to = to;
        chord.v = {};
        const MovingBall& ball = memory_.launched[i];
        const Arc& arc = memory_.arcs[i];
        if (to <= chord.from || !moves_centre(ball.motion)) return;
        if (arc.drag > 0) {
            const Real time = to - chord.from;
            chord.v = (way_under_drag(arc.drag, time) / time) * velocity(i, chord.from - arc.since);
        } else {
            chord.v = velocity(i, (chord.from - arc.since) / 2 + (to - arc.since) / 2);
        }
    }

    /// Of ball i, `time` s after its arc's beginning; m/s.
    [[nodiscard]] Vec3 velocity(std::size_t i, Real time) const {
        const MovingBall& ball = memory_.launched[i];
        const Arc& arc = memory_.arcs[i];
        if (arc.drag > 0) {
            const Vec2 v = elementary::exp(-arc.drag * time) * ball.v;
            return {v.x, v.y, 0};
        }
        const Vec2 v = ball.v + time * arc.a;
        return {v.x, v.y, ball.climb - time * arc.gravity};
    }

    /// From the contact's first body to the second, along their chords t s from now.
    [[nodiscard]] Vec3 towards(const Contact& contact, Real t) const {
        if (contact.kind == Contact::Kind::kRail) return {contact.normal.x, contact.normal.y, 0};
        return between_centres(balls_[contact.a], balls_[contact.b]) +
               t * (drift(contact.b) - drift(contact.a));
    }

    /// How fast the contact's bodies approach by their arcs at a time (s), times |n|.
    [[nodiscard]] Real approach_of(const Contact& contact, Vec3 n, Real at) const {
        const auto along = [&](std::size_t i) {
            return dot(velocity(i, at - memory_.arcs[i].since), n);
        };
        return contact.kind == Contact::Kind::kRail ? along(contact.a)
                                                    : along(contact.a) - along(contact.b);
    }

    /// How fast that grows; of arcs without drag.
    [[nodiscard]] Real growth_of(const Contact& contact, Vec3 n) const {
        const auto along = [&](std::size_t i) {
            const Arc& arc = memory_.arcs[i];
            return dot(Vec3{arc.a.x, arc.a.y, -arc.gravity}, n);
        };
        return contact.kind == Contact::Kind::kRail ? along(contact.a)
                                                    : along(contact.a) - along(contact.b);
    }

    const std::vector<MovingBall>& balls_;
    ExactArcMemory& memory_;
    std::vector<Chord>& chords_;
    Real tick_end_ = 0;  ///< s
};

}  // namespace poolhall
