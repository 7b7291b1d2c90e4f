#pragma once

#include "shared/physics/motion/cloth.hpp"
#include "shared/physics/solvers/impacts.hpp"
#include "shared/physics/solvers/instant_search.hpp"
#include "shared/physics/solvers/shot_run.hpp"
#include "shared/physics/solvers/stepping_memory.hpp"
#include "shared/physics/solvers/ticks.hpp"

#include <algorithm>
#include <vector>

namespace poolhall {

/// When the velocities change in a tick.
enum class Scheme {
    kEuler,         ///< after the places
    kSemiImplicit,  ///< before the places
};

/// Balls that go on with the velocities that they have.
class UniformPaths {
  public:
    explicit UniformPaths(const std::vector<MovingBall>& balls) : balls_(balls) {}

    [[nodiscard]] Vec3 drift(std::size_t i) const {
        const MovingBall& ball = balls_[i];
        return {ball.v.x, ball.v.y, ball.motion == Motion::kAirborne ? ball.climb : 0};
    }

    /// After an impact they part.
    [[nodiscard]] bool have_parted(std::size_t a, std::size_t b) const {
        return balls_[a].partner == b && balls_[b].partner == a;
    }

  private:
    const std::vector<MovingBall>& balls_;
};

/// Ticks of 1 / hz. Within one, motion is uniform, so contacts are found by their time of impact,
/// earliest first, as many as there are: nothing tunnels at any speed.
template <class Set, Scheme kScheme>
class SteppingSolver {
  public:
    SteppingSolver(const Set& set, ShotRun& run, SteppingMemory& memory)
        : set_(set),
          run_(run),
          balls_(run.balls()),
          cloth_(set, run.scene().gravity),
          memory_(memory),
          paths_(balls_),
          search_(set, run, memory, paths_) {}

    void solve() {
        for (MovingBall& ball : balls_)
            cloth_.settle(ball);
        search_.begin_shot();
        run_ticks(
            run_, [this] { return !memory_.moving.empty(); },
            [this](Real begin, Real end) { return tick(begin, end); },
            [this] { cloth_.update_spins(balls_); });
    }

  private:
    /// One tick from `begin` to `end`, in s.
    Outcome tick(Real begin, Real end) {
        const Real dt = end - begin;
        Real passed = 0;
        if constexpr (kScheme == Scheme::kSemiImplicit) kick_all(dt, begin);
        for (int round = 0; round < kMaxContactsPerTick; ++round) {
            if (run_.event_limit_reached()) return Outcome::kEventLimit;
            const Real rest = std::max(dt - passed, Real{0});
            search_.begin(rest);
            search_.look();
            const Real next = search_.first();
            run_.sample_before(std::min(begin + passed + std::min(next, rest), end), begin + passed,
                               [this](std::size_t i, Real time) { return place_after(i, time); });
            if (next > rest) {
                arrive(rest);
                if constexpr (kScheme == Scheme::kEuler) kick_all(dt, end);
                search_.claim_boxes(dt);
                run_.sample_at(end);
                return kGoesOn;
            }
            advance(next);
            passed += next;
            // Rounded, it could lie behind the tick's end, and its event behind those of the next.
            if (!happen(std::min(begin + passed, end))) return Outcome::kStalled;
            search_.note_changes();
        }
        return Outcome::kStalled;
    }

    [[nodiscard]] Vec3 place_after(std::size_t i, Real time) const {
        const Vec3 way = time * paths_.drift(i);
        return {balls_[i].r.x + way.x, balls_[i].r.y + way.y, height_after(i, time)};
    }

    [[nodiscard]] Real height_after(std::size_t i, Real time) const {
        if constexpr (Set::template kHook<hooks::Flight>)
            return balls_[i].height + time * paths_.drift(i).z;
        return balls_[i].height;
    }

    /// To the end of the time that was looked at.
    void arrive(Real time) {
        MovingBall* const balls = balls_.data();
        for (const std::size_t i : memory_.moving) {
            const Vec2 next = search_.next(i);
            balls[i].height = height_after(i, time);
            balls[i].r.x = next.x;
            balls[i].r.y = next.y;
        }
    }

    void advance(Real time) {
        for (const std::size_t i : memory_.moving) {
            balls_[i].height = height_after(i, time);
            balls_[i].r = balls_[i].r + time * balls_[i].v;
        }
    }

    void kick_all(Real dt, Real t) {
        MovingBall* const balls = balls_.data();
        const auto step = cloth_.step_of(dt);
        std::size_t kicked = 0;
        bool changed = false;
        const auto happened = [&](EventKind kind, const MovingBall& before) {
            run_.record(t, kind, kicked, before);
            changed = true;
        };
        for (const std::size_t i : memory_.moving) {
            kicked = i;
            cloth_.kick(balls[i], step, happened);
            // Friction may turn two balls towards each other again.
            if constexpr (Set::template kHook<hooks::Slip> || Set::template kHook<hooks::Roll>)
                balls[i].partner = MovingBall::kNobody;
        }
        if (changed) search_.note_changes();
    }

    /// Lets happen what the search found: captures, or else the contacts as one group. What is left
    /// is found again, 0 s from here.
    bool happen(Real t) {
        for (const auto& [ball, pocket] : memory_.captures) {
            cloth_.update_spin(balls_[ball]);
            run_.capture(t, ball, pocket);
        }
        if (!memory_.captures.empty()) return true;
        for (const Contact& contact : run_.workspace().contacts) {
            cloth_.update_spin(balls_[contact.a]);
            cloth_.update_spin(balls_[contact.b]);
        }
        lose_balls_over_rails(set_, run_, t);
        return resolve_contacts(set_, cloth_, run_, t);
    }

    const Set& set_;
    ShotRun& run_;
    std::vector<MovingBall>& balls_;
    Cloth<Set> cloth_;
    SteppingMemory& memory_;
    UniformPaths paths_;
    InstantSearch<Set, UniformPaths> search_;
};

}  // namespace poolhall
