#pragma once

#include "shared/physics/contact/time_of_impact.hpp"
#include "shared/physics/motion/cloth.hpp"
#include "shared/physics/search/table_hooks.hpp"
#include "shared/physics/solvers/shot_run.hpp"
#include "shared/physics/solvers/ticks.hpp"

#include <algorithm>
#include <optional>
#include <vector>

namespace poolhall {

/// The original game's way, with the mistakes of its text corrected: move every ball for a whole
/// tick, then look for overlaps, move the two balls back to their time of impact, exchange
/// velocities and move them on. A fast ball passes through others without ever overlapping them:
/// this solver is kept to show what that costs. One impact a pair and a tick.
template <class Set>
class OverlapSolver {
  public:
    OverlapSolver(const Set& set, ShotRun& run)
        : set_(set), run_(run), cloth_(set, run.scene().gravity) {}

    void solve() {
        for (MovingBall& ball : run_.balls())
            cloth_.settle(ball);
        run_ticks(
            run_, [this] { return run_.any_moves(); },
            [this](Real begin, Real end) { return tick(end - begin, end); },
            [this] { cloth_.update_spins(run_.balls()); });
    }

  private:
    static constexpr int kMaxReflections = 10000;

    Outcome tick(Real dt, Real end) {
        const std::size_t first_event = run_.event_count();
        for (MovingBall& ball : run_.balls())
            ball.r = ball.r + dt * ball.v;
        separate_pairs(dt, end);
        if constexpr (Set::template kHook<hooks::StraightRails>) {
            for (std::size_t i = 0; i < run_.balls().size(); ++i) {
                if (!bounce(i, dt, end)) return Outcome::kStalled;
            }
        }
        capture(end);
        kick_all(dt, end);
        run_.sort_events_from(first_event);
        run_.sample_at(end);
        return kGoesOn;
    }

    void separate_pairs(Real dt, Real end) {
        const std::vector<MovingBall>& balls = run_.balls();
        for (std::size_t a = 0; a < balls.size(); ++a) {
            for (std::size_t b = a + 1; b < balls.size(); ++b) {
                if (in_play(balls[a]) && in_play(balls[b])) separate(a, b, dt, end);
            }
        }
    }

    /// Text, 5.2.1.
    void separate(std::size_t a, std::size_t b, Real dt, Real end) {
        MovingBall& first = run_.balls()[a];
        MovingBall& second = run_.balls()[b];
        const Real distance = contact_distance(first, second);
        const Vec2 c = first.r - second.r;
        const Vec2 v = second.v - first.v;
        if (dot(c, c) >= distance * distance || v == Vec2{}) return;
        // Never before this tick, even where an earlier tick left an overlap behind.
        const Real since =
            std::min(time_since_impact({first.r, first.v}, {second.r, second.v}, distance), dt);
        const Vec2 met_first = first.r - since * first.v;
        const Vec2 met_second = second.r - since * second.v;
        // Separating when they touched: they have overlapped from the start, and there is no impact
        // to find.
        if (dot(met_first - met_second, v) <= 0) return;
        first.r = met_first;
        second.r = met_second;
        impact(ball_contact(a, b), end - since);
        first.r = first.r + since * first.v;
        second.r = second.r + since * second.v;
    }

    void impact(const Contact& contact, Real t) {
        MovingBall& a = run_.balls()[contact.a];
        MovingBall& b = run_.balls()[contact.b];
        cloth_.update_spin(a);
        cloth_.update_spin(b);
        const MovingBall before_a = a;
        const MovingBall before_b = b;
        // One contact always settles.
        (void)run_.workspace().contact_solver.resolve({&contact, 1}, run_.balls());
        cloth_.settle(a);
        if (contact.kind == Contact::Kind::kRail) {
            run_.record_rail(t, contact.a, contact.rail, before_a);
        } else {
            cloth_.settle(b);
            run_.record_pair(t, contact.a, contact.b, before_a, before_b);
        }
    }

    /// Text, 5.2.2, repeated until no rail is crossed: a fast ball can cross the table within a
    /// tick.
    bool bounce(std::size_t i, Real dt, Real end) {
        const MovingBall& ball = run_.balls()[i];
        if (!in_play(ball)) return true;
        const Vec2 edge = set_.template hook<hooks::StraightRails>().edge(ball.reach);
        for (int round = 0; round < kMaxReflections; ++round) {
            if (abs(ball.r.x) > edge.x) {
                reflect(i, ball.r.x > 0 ? Rail::kEast : Rail::kWest, dt, end);
            } else if (abs(ball.r.y) > edge.y) {
                reflect(i, ball.r.y > 0 ? Rail::kNorth : Rail::kSouth, dt, end);
            } else {
                return true;
            }
        }
        return false;
    }

    void reflect(std::size_t i, Rail rail, Real dt, Real end) {
        MovingBall& ball = run_.balls()[i];
        const bool short_rail = rail == Rail::kEast || rail == Rail::kWest;
        const Vec2 edges = set_.template hook<hooks::StraightRails>().edge(ball.reach);
        const Real edge = short_rail ? edges.x : edges.y;
        Real& r = short_rail ? ball.r.x : ball.r.y;
        const Real& v = short_rail ? ball.v.x : ball.v.y;
        const Real wall = r > 0 ? edge : -edge;
        const Real beyond = r - wall;
        // An impact within this tick may have moved the ball beyond the rail on its way back.
        if (v * beyond <= 0) {
            r = wall - beyond;
            return;
        }
        // Never before this tick, even where an impact has left the ball beyond the rail.
        const Real since = std::min(beyond / v, dt);
        const Real arrived = v;
        const Vec2 place = ball.r;
        ball.r = ball.r - since * ball.v;
        r = wall;
        impact(rail_contact(i, rail), end - since);
        ball.r = place;
        r = wall + v / arrived * beyond;
    }

    void capture(Real end) {
        set_.for_each([&]<PocketEffect Pockets>(const Pockets& pockets) {
            for (std::size_t i = 0; i < run_.balls().size(); ++i) {
                MovingBall& ball = run_.balls()[i];
                if (!in_play(ball) || ball.v == Vec2{}) continue;
                if (const std::optional<Pocket> pocket = pockets.at(ball.r)) {
                    cloth_.update_spin(ball);
                    run_.capture(end, i, *pocket);
                }
            }
        });
    }

    void kick_all(Real dt, Real end) {
        const auto step = cloth_.step_of(dt);
        for (std::size_t i = 0; i < run_.balls().size(); ++i) {
            MovingBall& ball = run_.balls()[i];
            if (!in_play(ball) || ball.motion == Motion::kStationary) continue;
            cloth_.kick(ball, step, [&](EventKind kind, const MovingBall& before) {
                run_.record(end, kind, i, before);
            });
        }
    }

    const Set& set_;
    ShotRun& run_;
    Cloth<Set> cloth_;
};

}  // namespace poolhall
