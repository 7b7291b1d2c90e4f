#pragma once

#include "shared/physics/motion/cloth.hpp"
#include "shared/physics/solvers/chords.hpp"
#include "shared/physics/solvers/exact_arc_memory.hpp"
#include "shared/physics/solvers/impacts.hpp"
#include "shared/physics/solvers/instant_search.hpp"
#include "shared/physics/solvers/shot_run.hpp"
#include "shared/physics/solvers/ticks.hpp"

#include <algorithm>
#include <vector>

namespace poolhall {

/// Ticks of 1 / hz in which every ball moves in closed form. Contacts are found on chords of the
/// arcs (chords.hpp), so their error is of second order; a ball that meets nothing is exact.
///
/// A contact happens only if the balls approach there by their arcs too. Where only the chords do,
/// they are taken anew, up to where the arcs' approach changes sign (Chords::end_of_false_contact):
/// balls that friction presses together bounce off each other in many small arcs, and a chord over
/// several of them would lead through the other ball.
template <class Set>
class ExactArcSolver {
  public:
    ExactArcSolver(const Set& set, ShotRun& run, ExactArcMemory& memory)
        : set_(set),
          run_(run),
          balls_(run.balls()),
          cloth_(set, run.scene().gravity),
          memory_(memory),
          contacts_(run.workspace().contacts),
          chords_(balls_, memory),
          search_(set, run, memory.stepping, chords_) {}

    void solve() {
        for (MovingBall& ball : balls_)
            cloth_.settle(ball);
        chords_.begin_shot();
        for (std::size_t i = 0; i < balls_.size(); ++i)
            launch(i, 0);
        search_.begin_shot();
        run_ticks(
            run_, [this] { return !memory_.stepping.moving.empty(); },
            [this](Real begin, Real end) { return tick(begin, end); }, [] {});
    }

  private:
    /// One tick from `begin` to `end`, in s.
    Outcome tick(Real begin, Real end) {
        const Real dt = end - begin;
        Real passed = 0;
        chords_.begin_tick(begin, end, memory_.stepping.moving);
        for (int round = 0; round < kMaxContactsPerTick; ++round) {
            if (run_.event_limit_reached()) return Outcome::kEventLimit;
            const Real rest = std::max(dt - passed, Real{0});
            const Real now = begin + passed;
            find_first(now, rest);
            const Real next = search_.first();
            if (next <= rest && renew_chords(now, next)) continue;
            run_.sample_before(std::min(now + std::min(next, rest), end), now,
                               [this](std::size_t i, Real time) { return place_after(i, time); });
            if (next > rest) {
                arrive(end);
                search_.claim_boxes(dt);
                run_.sample_at(end);
                return kGoesOn;
            }
            advance(next);
            passed += next;
            // Rounded, it could lie behind the tick's end, and its event behind those of the next.
            if (!happen(std::min(begin + passed, end))) return Outcome::kStalled;
        }
        return Outcome::kStalled;
    }

    void find_first(Real now, Real time) {
        search_.begin(time);
        for (const std::size_t i : memory_.stepping.moving) {
            const Real t = chords_.ends_within_tick(i, now);
            if (t <= time && search_.is_first(t)) memory_.stepping.transitions.push_back(i);
        }
        search_.look();
    }

    /// Takes the chords of false contacts anew. False if there is none.
    bool renew_chords(Real now, Real t) {
        std::vector<Real>& ends = memory_.ends;
        ends.clear();
        for (const Contact& contact : contacts_)
            ends.push_back(chords_.end_of_false_contact(contact, now, t));
        bool any = false;
        for (std::size_t k = 0; k < ends.size(); ++k) {
            if (ends[k] == kNever) continue;
            chords_.renew(contacts_[k].a, now, ends[k]);
            chords_.renew(contacts_[k].b, now, ends[k]);
            any = true;
        }
        return any;
    }

    [[nodiscard]] Vec3 place_after(std::size_t i, Real time) const {
        const MovingBall& ball = balls_[i];
        const Vec3 way = time * chords_.drift(i);
        if constexpr (Set::template kHook<hooks::Flight>)
            return {ball.r.x + way.x, ball.r.y + way.y, ball.height + way.z};
        return {ball.r.x + way.x, ball.r.y + way.y, ball.height};
    }

    void advance(Real time) {
        for (const std::size_t i : memory_.stepping.moving) {
            const Vec3 place = place_after(i, time);
            balls_[i].r = xy(place);
            balls_[i].height = place.z;
        }
    }

    /// Every ball at `t`, the end of the time looked at, as its arc has it.
    void arrive(Real t) {
        for (const std::size_t i : memory_.stepping.moving) {
            const std::size_t partner = balls_[i].partner;
            balls_[i] = ball_on(memory_.launched[i], memory_.arcs[i], t);
            balls_[i].partner = partner;
            // Straight on, the way within a tick is more exact than that since the last event.
            if (memory_.arcs[i].a == Vec2{} && memory_.arcs[i].drag == 0)
                balls_[i].r = search_.next(i);
        }
    }

    void launch(std::size_t i, Real t) {
        memory_.launched[i] = balls_[i];
        memory_.arcs[i] = cloth_.arc_of(balls_[i], t);
        chords_.aim(i, t);
    }

    /// Lets happen what the search found: ends of chords, or else captures, or else the contacts as
    /// one group. What is left is found again, 0 s from here.
    bool happen(Real t) {
        bool settled = true;
        if (!memory_.stepping.transitions.empty()) {
            for (const std::size_t i : memory_.stepping.transitions)
                end_chord(i, t);
        } else if (!memory_.stepping.captures.empty()) {
            for (const auto& [ball, pocket] : memory_.stepping.captures)
                run_.capture(t, ball, pocket);
        } else {
            settled = collide(t);
        }
        search_.note_changes();
        return settled;
    }

    void end_chord(std::size_t i, Real t) {
        if (!chords_.ends_with_arc(i)) {
            chords_.aim(i, t);
            return;
        }
        balls_[i] = memory_.launched[i];
        cloth_.transition(
            balls_[i], memory_.arcs[i],
            [&](EventKind kind, const MovingBall& before) { run_.record(t, kind, i, before); });
        launch(i, t);
    }

    bool collide(Real t) {
        for (const Contact& contact : contacts_) {
            prepare_for_impact(contact.a, t);
            prepare_for_impact(contact.b, t);
        }
        lose_balls_over_rails(set_, run_, t);
        if (!resolve_contacts(set_, cloth_, run_, t)) return false;
        for (const Contact& contact : contacts_) {
            launch(contact.a, t);
            launch(contact.b, t);
        }
        return true;
    }

    /// Velocities and spins as they are at t; places stay on the chord, where the contact was
    /// found.
    void prepare_for_impact(std::size_t i, Real t) {
        MovingBall& ball = balls_[i];
        if (ball.motion == Motion::kStationary) return;
        const MovingBall found = ball;
        ball = ball_on(memory_.launched[i], memory_.arcs[i], t);
        ball.r = found.r;
        ball.height = found.height;
        ball.partner = found.partner;
    }

    const Set& set_;
    ShotRun& run_;
    std::vector<MovingBall>& balls_;
    Cloth<Set> cloth_;
    ExactArcMemory& memory_;
    std::vector<Contact>& contacts_;
    Chords chords_;
    InstantSearch<Set, Chords> search_;
};

}  // namespace poolhall
