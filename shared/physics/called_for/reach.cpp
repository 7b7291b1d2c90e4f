#include "shared/physics/called_for/reach.hpp"

#include "shared/physics/called_for/free_path.hpp"

#include <algorithm>

namespace poolhall {

namespace {

/// Of the radius; wider than any rounding. What is left out is kept clear of by as much.
constexpr Real kMargin = 1 + 0x1p-20;

Box around(const MovingBall& ball) {
    return Box::around(ball.r, ball.r, ball.radius);
}

/// Where no rubber is.
bool is_between_noses(const Table& table, const Box& box) {
    const Vec2 nose{table.length / 2, table.width / 2};
    return box.low_x > -nose.x && box.high_x < nose.x && box.low_y > -nose.y && box.high_y < nose.y;
}

bool is_apart_from_others(const Box& box, std::span<const MovingBall> balls, std::size_t ball) {
    for (std::size_t i = 0; i < balls.size(); ++i) {
        if (i != ball && !are_apart(box, around(balls[i]))) return false;
    }
    return true;
}

/// A ball that has twice the table before it: no bound would be of use.
bool is_too_fast(const MovingBall& ball, const ClothLaws& cloth, const Table& table) {
    return dot(ball.v, ball.v) > 4 * cloth.roll * table.length && cloth.drag == 0;
}

Real least_mass_of(std::span<const MovingBall> balls) {
    Real least = kInfinity;
    for (const MovingBall& ball : balls)
        least = std::min(least, ball.mass);
    return least;
}

/// Way times mass that balls can do with some energy, handed on from ball to ball.
class EnergyReach {
  public:
    EnergyReach(std::span<const MovingBall> balls, Real most, ReachMemory& memory)
        : balls_(balls), most_(most), reached_(memory.reached) {}

    void find(const Table& table, Prospect& prospect) {
        reached_.assign(balls_.size(), {});
        std::size_t movers = 0;
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            if (is_at_rest(balls_[i])) continue;
            reached_[i].spent = 0;
            ++movers;
        }
        std::size_t count = 0;
        for (std::size_t i = next(); i < balls_.size(); i = next()) {
            spread(i);
            ++count;
        }
        prospect.reach = surfaces_;
        prospect.reach_is_bounded = true;
        prospect.reach_is_by_energy = true;
        prospect.meets = movers > 1 || count > 1;
        prospect.rails = table.rails && !is_between_noses(table, surfaces_);
    }

  private:
    /// Of those left the one that moves first for the least; how many balls there are if none is.
    [[nodiscard]] std::size_t next() const {
        std::size_t best = balls_.size();
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            if (reached_[i].done || reached_[i].spent > most_) continue;
            if (best == balls_.size() || reached_[i].spent < reached_[best].spent) best = i;
        }
        return best;
    }

    /// Lets ball i go as far as it can, and come to others.
    void spread(std::size_t i) {
        const MovingBall& ball = balls_[i];
        const Real spent = reached_[i].spent;
        const Real way = (most_ - spent) / ball.mass;
        reached_[i].done = true;
        surfaces_ = united(surfaces_, Box::around(ball.r, ball.r, ball.radius + way));
        for (std::size_t j = 0; j < balls_.size(); ++j) {
            if (reached_[j].done) continue;
            const Real touch = kMargin * (ball.radius + balls_[j].radius);
            const Vec2 c = balls_[j].r - ball.r;
            if (dot(c, c) > (way + touch) * (way + touch)) continue;
            const Real gap = std::max(norm(c) - touch, Real{0});
            reached_[j].spent = std::min(reached_[j].spent, spent + ball.mass * gap);
        }
    }

    std::span<const MovingBall> balls_;
    Real most_;  ///< kg m
    std::vector<ReachMemory::Reached>& reached_;
    Box surfaces_ = Box::nothing();
};

/// A look through the events of a trace.
class ReachCheck {
  public:
    ReachCheck(const Prospect& prospect, const Scene& scene, std::vector<ReachMemory::Seen>& last)
        : prospect_(prospect), scene_(scene), tick_(ClothLaws(scene).tick), last_(last) {}

    [[nodiscard]] bool passes(const ShotTrace& trace) {
        last_.clear();
        for (const SceneBall& ball : scene_.balls) {
            const auto& [r, v, w] = ball.state;
            last_.push_back({xy(r), xy(v), 0, v != Vec3{} || w != Vec3{}});
        }
        for (const ShotEvent& event : trace.events) {
            if (event.kind == EventKind::kBallBall && !prospect_.meets) return false;
            for (std::size_t k = 0; k < event.ball_count; ++k) {
                const std::size_t ball = event.balls[k].value;
                last_[ball].moves = true;
                if (!came_within(ball, event.t, event.before[k])) return false;
                last_[ball] = {xy(event.after[k].r), xy(event.after[k].v), event.t, true};
            }
        }
        for (std::size_t i = 0; i < trace.balls.size(); ++i) {
            if (last_[i].moves && !came_within(i, trace.duration, trace.balls[i].state))
                return false;
        }
        return true;
    }

  private:
    /// From where the ball was last seen to `state`, at t, on a parabola: within its control
    /// polygon. By ticks it is beside it by half the change of velocity in one.
    [[nodiscard]] bool came_within(std::size_t i, Real t, const BallState& state) const {
        const auto& [r, v, since, moves] = last_[i];
        const Vec2 end = xy(state.v);
        const Real beside = tick_ > 0 ? tick_ * (abs(v.x) + abs(v.y) + abs(end.x) + abs(end.y)) : 0;
        const Real reach = radius_of(scene_, scene_.balls[i]) + beside;
        return holds(r, reach) && holds(r + (t - since) / 2 * v, reach) &&
               holds(xy(state.r), reach);
    }

    [[nodiscard]] bool holds(Vec2 place, Real radius) const {
        const Box& box = prospect_.reach;
        return place.x - radius >= box.low_x && place.x + radius <= box.high_x &&
               place.y - radius >= box.low_y && place.y + radius <= box.high_y;
    }

    const Prospect& prospect_;
    const Scene& scene_;
    Real tick_;  ///< s
    std::vector<ReachMemory::Seen>& last_;
};

}  // namespace

void bound_reach(const Scene& scene, std::span<const MovingBall> balls, const Start& start,
                 ReachMemory& memory, Prospect& prospect) {
    // It moves balls to and fro within a tick.
    if (scene.solver.kind == SolverKind::kOverlap) return;
    const ClothLaws cloth(scene);
    if (start.movers == 1) {
        const MovingBall& ball = balls[start.a_mover];
        if (is_too_fast(ball, cloth, scene.table)) return;
        const std::optional<Box> path = free_path(ball, cloth);
        if (!path) return;
        if ((!scene.table.rails || is_between_noses(scene.table, *path)) &&
            is_apart_from_others(*path, balls, start.a_mover)) {
            prospect.reach = *path;
            prospect.reach_is_bounded = true;
            prospect.meets = false;
            prospect.rails = false;
            return;
        }
    }
    // Farther, it would leave out nothing of a table that is in use.
    const Real most = way_for_energy(cloth) * start.energy;
    if (most < least_mass_of(balls) * scene.table.width / 2)
        EnergyReach(balls, most, memory).find(scene.table, prospect);
}

bool stayed_within(const Prospect& prospect, const Scene& scene, const ShotTrace& trace,
                   ReachMemory& memory) {
    return ReachCheck(prospect, scene, memory.last).passes(trace);
}

}  // namespace poolhall
