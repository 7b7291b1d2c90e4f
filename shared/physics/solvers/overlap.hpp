#pragma once

#include "shared/physics/effects/ball_ball.hpp"
#include "shared/physics/effects/effect_set.hpp"
#include "shared/physics/shot_run.hpp"
#include "shared/physics/solvers/stepping.hpp"
#include "shared/physics/time_of_impact.hpp"

#include <algorithm>
#include <cmath>
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
    OverlapSolver(const Set& set, ShotRun& run) : set_(set), run_(run) {}

    void solve() {
        run_ticks(run_, [this](double begin, double end) { return tick(end - begin, end); });
    }

  private:
    static constexpr int kMaxReflections = 10000;

    Outcome tick(double dt, double end) {
        const std::size_t first_event = run_.event_count();
        for (MovingBall& ball : run_.balls())
            ball.r = ball.r + dt * ball.v;
        separate_pairs(dt, end);
        if constexpr (Set::template kHas<Rails>) {
            for (std::size_t i = 0; i < run_.balls().size(); ++i) {
                if (!bounce(i, dt, end)) return Outcome::kStalled;
            }
        }
        if constexpr (Set::template kHas<EndGamePockets>) capture(end);
        if constexpr (Set::template kHas<LinearDrag>)
            slow_down(run_, set_.template effect<LinearDrag>(), dt, end);
        run_.sort_events_from(first_event);
        run_.sample_at(end);
        return Outcome::kRest;
    }

    void separate_pairs(double dt, double end) {
        std::vector<MovingBall>& balls = run_.balls();
        for (std::size_t a = 0; a < balls.size(); ++a) {
            for (std::size_t b = a + 1; b < balls.size(); ++b) {
                if (balls[a].in_play && balls[b].in_play) separate(a, b, dt, end);
            }
        }
    }

    /// Text, 5.2.1.
    void separate(std::size_t a, std::size_t b, double dt, double end) {
        MovingBall& first = run_.balls()[a];
        MovingBall& second = run_.balls()[b];
        const double diameter = 2 * run_.scene().ball.radius;
        const Vec2 c = first.r - second.r;
        const Vec2 v = second.v - first.v;
        if (dot(c, c) >= diameter * diameter || v == Vec2{}) return;
        // Never before this tick, even where an earlier tick left an overlap behind.
        const double since =
            std::min(time_since_impact({first.r, first.v}, {second.r, second.v}, diameter), dt);
        const MovingBall met_first{first.r - since * first.v, first.v};
        const MovingBall met_second{second.r - since * second.v, second.v};
        // Separating when they touched: they have overlapped from the start, and there is no impact
        // to find.
        if (dot(met_first.r - met_second.r, v) <= 0) return;
        first = met_first;
        second = met_second;
        exchange_normal_velocity(first.v, second.v, normalized(second.r - first.r));
        run_.record_pair(end - since, a, b, met_first, met_second);
        first.r = first.r + since * first.v;
        second.r = second.r + since * second.v;
    }

    /// Text, 5.2.2, repeated until no rail is crossed: a fast ball can cross the table within a
    /// tick.
    bool bounce(std::size_t i, double dt, double end) {
        MovingBall& ball = run_.balls()[i];
        if (!ball.in_play) return true;
        const Vec2 edge = set_.template effect<Rails>().edge();
        for (int round = 0; round < kMaxReflections; ++round) {
            if (std::abs(ball.r.x) > edge.x) {
                reflect(i, ball.r.x > 0 ? Rail::kEast : Rail::kWest, dt, end);
            } else if (std::abs(ball.r.y) > edge.y) {
                reflect(i, ball.r.y > 0 ? Rail::kNorth : Rail::kSouth, dt, end);
            } else {
                return true;
            }
        }
        return false;
    }

    void reflect(std::size_t i, Rail rail, double dt, double end) {
        MovingBall& ball = run_.balls()[i];
        const auto& rails = set_.template effect<Rails>();
        const bool short_rail = rail == Rail::kEast || rail == Rail::kWest;
        double& r = short_rail ? ball.r.x : ball.r.y;
        double& v = short_rail ? ball.v.x : ball.v.y;
        const double edge = short_rail ? rails.edge().x : rails.edge().y;
        const double wall = r > 0 ? edge : -edge;
        const double beyond = r - wall;
        const double back = wall - rails.restitution() * beyond;
        // An impact within this tick may have moved the ball beyond the rail on its way back.
        if (v * beyond <= 0) {
            r = back;
            return;
        }
        // Never before this tick, even where an impact has left the ball beyond the rail.
        const double since = std::min(beyond / v, dt);
        const Vec2 place{short_rail ? back : ball.r.x, short_rail ? ball.r.y : back};
        ball.r = ball.r - since * ball.v;
        r = wall;
        const MovingBall met = ball;
        v = -rails.restitution() * v;
        run_.record_rail(end - since, i, rail, met);
        ball.r = place;
    }

    void capture(double end) {
        for (std::size_t i = 0; i < run_.balls().size(); ++i) {
            const MovingBall& ball = run_.balls()[i];
            if (!ball.in_play || ball.v == Vec2{}) continue;
            const std::optional<Pocket> pocket = set_.template effect<EndGamePockets>().at(ball.r);
            if (pocket) run_.capture(end, i, *pocket);
        }
    }

    const Set& set_;
    ShotRun& run_;
};

}  // namespace poolhall
