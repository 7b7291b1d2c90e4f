#pragma once

#include "shared/physics/contact/contact_time.hpp"
#include "shared/physics/contact/time_of_impact.hpp"
#include "shared/physics/motion/cloth_hooks.hpp"
#include "shared/physics/search/table_hooks.hpp"
#include "shared/physics/solvers/shot_run.hpp"
#include "shared/physics/solvers/stepping_memory.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>
#include <vector>

namespace poolhall {

/// The next double after x >= 0; std::nextafter would be a call of the C library.
constexpr double next_above(double x) {
    return std::bit_cast<Real>(std::bit_cast<std::uint64_t>(x) + 1);
}

/// Finds what happens first while every ball goes straight and uniformly for some time: captures by
/// pockets, contacts of balls, contacts with rails. `Paths` tells how they go:
///
///     Vec3 drift(std::size_t ball) const;                    // its velocity, m/s
///     bool have_parted(std::size_t a, std::size_t b) const;  // cannot meet, but by rounding
///
/// Only loose balls (free_boxes.hpp) are looked at. What is found is in the memory's `captures`
/// and the workspace's `contacts`, in the order of effects and balls.
template <class Set, class Paths>
class InstantSearch {
  public:
    InstantSearch(const Set& set, ShotRun& run, SteppingMemory& memory, const Paths& paths)
        : set_(set),
          paths_(paths),
          table_(run.scene().table),
          balls_(run.balls()),
          work_(run.workspace()),
          memory_(memory) {}

    /// To be called once, with settled balls.
    void begin_shot() {
        const Vec2 half{table_.length / 2, table_.width / 2};
        memory_.boxes.reset(balls_.size(), {-half.x, half.x, -half.y, half.y}, work_.many_balls);
        memory_.next.resize(balls_.size());
        memory_.moving.reset(balls_.size());
        memory_.loose.reset(balls_.size());
        memory_.plans.clear();
        for (const MovingBall& ball : balls_)
            memory_.plans.push_back({clear_area(ball.radius), kMostTicks});
        note_changes();
    }

    /// To be called after balls have changed their motion.
    void note_changes() {
        memory_.moving.clear();
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            if (!in_play(balls_[i])) {
                memory_.boxes.remove(i);
            } else if (balls_[i].motion == Motion::kStationary) {
                memory_.boxes.settle(i, balls_[i].r, balls_[i].radius);
            } else {
                memory_.boxes.wake(i);
                memory_.moving.push_back(i);
            }
        }
    }

    /// Begins to look at the next `time` s.
    void begin(Real time) {
        forget();
        time_ = time;
        first_ = next_above(time);
    }

    /// True if an event at t (s from now) is among the first; forgets later ones.
    bool is_first(Real t) {
        if (t > first_) return false;
        if (t < first_) forget();
        first_ = t;
        return true;
    }

    /// When what happens first happens, s from now; more than the time looked at if nothing does.
    [[nodiscard]] Real first() const { return first_; }

    /// Looks at all of the time. Afterwards next() is valid.
    void look() {
        if (!find_loose()) return;
        find_captures();
        find_ball_contacts();
        find_rail_contacts();
    }

    /// Where a moving ball is at the end of the time, m.
    [[nodiscard]] Vec2 next(std::size_t ball) const { return memory_.next[ball]; }

    /// To be called at the end of a tick of dt s: gives boxes to loose balls for the ticks to come.
    void claim_boxes(Real dt) {
        for (const std::size_t i : memory_.loose)
            claim_box(i, dt);
    }

  private:
    /// For how many ticks and ball's radii of way a box is made at most.
    static constexpr Real kMostTicks = 64;
    static constexpr Real kLongest = 4;

    void forget() {
        work_.contacts.clear();
        memory_.captures.clear();
        memory_.transitions.clear();
    }

    bool find_loose() {
        const MovingBall* const balls = balls_.data();
        Vec2* const places = memory_.next.data();
        memory_.loose.clear();
        for (const std::size_t i : memory_.moving) {
            const Vec3 v = paths_.drift(i);
            const Vec2 next{balls[i].r.x + time_ * v.x, balls[i].r.y + time_ * v.y};
            places[i].x = next.x;
            places[i].y = next.y;
            if (!memory_.boxes.holds(i, next)) [[unlikely]]
                memory_.loose.push_back(i);
        }
        for (const std::size_t i : memory_.loose)
            memory_.boxes.sweep(i, balls[i].r, places[i], balls[i].radius);
        return !memory_.loose.empty();
    }

    void claim_box(std::size_t i, Real dt) {
        const MovingBall& ball = balls_[i];
        if (!in_play(ball) || ball.motion == Motion::kStationary) return;
        BoxPlan& plan = memory_.plans[i];
        if (!plan.is_alone) return;
        const Vec2 step = dt * xy(paths_.drift(i));
        const Real longest = kLongest * ball.radius / (abs(step.x) + abs(step.y));
        const Vec2 way = std::min(plan.ticks, longest) * step;
        const Vec2 clear = plan.clear;
        if (abs(ball.r.x) > clear.x || abs(ball.r.y) > clear.y) return;
        // Its way bends.
        const Real margin = (abs(way.x) + abs(way.y)) / 16;
        const Box box{std::max(std::min(ball.r.x, ball.r.x + way.x) - margin, -clear.x),
                      std::min(std::max(ball.r.x, ball.r.x + way.x) + margin, clear.x),
                      std::max(std::min(ball.r.y, ball.r.y + way.y) - margin, -clear.y),
                      std::min(std::max(ball.r.y, ball.r.y + way.y) + margin, clear.y)};
        if (memory_.boxes.claim(i, box, ball.radius)) {
            plan.ticks = std::min(2 * plan.ticks, kMostTicks);
        } else {
            plan.ticks = std::max(plan.ticks / 2, Real{1});
        }
    }

    /// Up to which |x| and |y| a ball meets nothing of the table, by more than any rounding, m.
    [[nodiscard]] Vec2 clear_area(Real radius) const {
        constexpr Real kSafe = 1 - 0x1p-30;
        Vec2 area{kNever, kNever};
        set_.for_each([&]<OuterEffect Effect>(const Effect& effect) {
            const Vec2 clear = effect.clear_area(radius);
            area = {std::min(area.x, kSafe * clear.x), std::min(area.y, kSafe * clear.y)};
        });
        // Of other pockets nothing is known.
        set_.for_each([&]<PocketEffect Pockets>(const Pockets&) {
            if constexpr (!OuterEffect<Pockets>) area = {-kNever, -kNever};
        });
        return area;
    }

    void find_captures() {
        set_.for_each([&]<PocketEffect Pockets>(const Pockets& pockets) {
            for (const std::size_t i : memory_.loose) {
                if (!is_on_cloth(balls_[i].motion)) continue;
                const Vec2 v = xy(paths_.drift(i));
                if (v == Vec2{}) continue;
                const std::optional<Capture> capture = pockets.first_capture(balls_[i].r, v, time_);
                if (capture && is_first(capture->t))
                    memory_.captures.push_back({i, capture->pocket});
            }
        });
    }

    void find_ball_contacts() {
        for (const std::size_t i : memory_.loose) {
            memory_.plans[i].is_alone = true;
            memory_.boxes.for_each_near(i, [&](std::size_t j) {
                memory_.plans[i].is_alone = false;
                // Two loose balls find each other twice.
                if (j < i && memory_.boxes.is_loose(j)) return;
                find_ball_contact(std::min(i, j), std::max(i, j));
            });
        }
        if (work_.contacts.size() < 2) return;
        std::sort(
            work_.contacts.begin(), work_.contacts.end(),
            [](const Contact& c, const Contact& d) { return c.a != d.a ? c.a < d.a : c.b < d.b; });
    }

    void find_ball_contact(std::size_t i, std::size_t j) {
        if (paths_.drift(i) == paths_.drift(j) || paths_.have_parted(i, j)) return;
        if (stay_apart(i, j)) return;
        Real t = meeting(i, j);
        if (t > time_ && slips_by(i, j, t)) t = time_;
        if (t > time_ || rest_against(i, j)) return;
        if (is_first(t)) work_.contacts.push_back(ball_contact(i, j));
    }

    /// True for most balls on the cloth that do not meet, by their distance along the line of
    /// centres at the end of the time: near each other, the time itself takes many more digits.
    [[nodiscard]] bool stay_apart(std::size_t i, std::size_t j) const {
        constexpr Real kSafe = 1 + 0x1p-16;
        if (is_in_air(i) || is_in_air(j)) return false;
        const Vec2 c = balls_[j].r - balls_[i].r;
        const Vec2 v = xy(paths_.drift(j)) - xy(paths_.drift(i));
        const Real square = dot(c, c);
        const Real distance = contact_distance(balls_[i], balls_[j]);
        const Real least = square + std::min(dot(c, v), Real{0}) * (kSafe * time_);
        return least > 0 && least * least > (1 + kTouchRounding) * square * distance * distance;
    }

    [[nodiscard]] Real meeting(std::size_t i, std::size_t j) const {
        const MovingBall& a = balls_[i];
        const MovingBall& b = balls_[j];
        const Vec3 v_a = paths_.drift(i);
        const Vec3 v_b = paths_.drift(j);
        if constexpr (Set::template kHook<hooks::Flight>) {
            if (a.height != b.height || v_a.z != v_b.z)
                return straight_contact(between_centres(a, b), v_b - v_a, a.radius + b.radius);
        }
        return time_of_impact({a.r, xy(v_a)}, {b.r, xy(v_b)}, contact_distance(a, b))
            .value_or(kNever);
    }

    /// True for a graze that is due only just after the time looked at: from where rounding puts
    /// the balls then, they may not approach any more.
    [[nodiscard]] bool slips_by(std::size_t i, std::size_t j, Real t) const {
        constexpr Real kSoon = 1 + 0x1p-20;
        constexpr Real kGraze = 0x1p16 * kEpsilon * kEpsilon;
        if (t > kSoon * time_ || is_in_air(i) || is_in_air(j)) return false;
        const Vec2 v = xy(paths_.drift(j)) - xy(paths_.drift(i));
        const Vec2 c = (balls_[j].r - balls_[i].r) + time_ * v;
        const Real approach = -dot(c, v);
        return approach <= 0 || approach * approach <= kGraze * dot(c, c) * dot(v, v);
    }

    [[nodiscard]] bool is_in_air(std::size_t i) const {
        return balls_[i].motion == Motion::kAirborne;
    }

    /// True for balls that touch and approach no more than rounding makes them. An impact would
    /// only hand that rounding to and fro between them and what holds them, without end; left alone
    /// it makes an overlap far below kTouchTolerance.
    [[nodiscard]] bool rest_against(std::size_t i, std::size_t j) const {
        const MovingBall& a = balls_[i];
        const MovingBall& b = balls_[j];
        const Vec3 v_a = paths_.drift(i);
        const Vec3 v_b = paths_.drift(j);
        const Real speed = std::max({abs(v_a.x), abs(v_a.y), abs(v_b.x), abs(v_b.y)});
        if constexpr (Set::template kHook<hooks::Flight>) {
            if (is_in_air(i) || is_in_air(j))
                return touch_and_rest(between_centres(a, b), v_b - v_a, a.radius + b.radius,
                                      std::max({speed, abs(v_a.z), abs(v_b.z)}));
        }
        return touch_and_rest(b.r - a.r, xy(v_b) - xy(v_a), contact_distance(a, b), speed);
    }

    template <class Vec>
    [[nodiscard]] static bool touch_and_rest(const Vec& c, const Vec& v, Real distance,
                                             Real speed) {
        return dot(c, c) <= (1 + kTouchRounding) * distance * distance &&
               -dot(c, v) <= kTouchRounding * distance * speed;
    }

    void find_rail_contacts() {
        if constexpr (Set::template kHook<hooks::StraightRails>) {
            const auto& rails = set_.template hook<hooks::StraightRails>();
            for (const std::size_t i : memory_.loose) {
                const Vec2 v = xy(paths_.drift(i));
                if (!rails.may_reach(balls_[i], v, time_)) continue;
                for (const auto& hit :
                     {rails.next_short_rail(balls_[i], v), rails.next_long_rail(balls_[i], v)}) {
                    if (hit && is_first(hit->t))
                        work_.contacts.push_back(rail_contact(i, hit->rail));
                }
            }
        }
        if constexpr (Set::template kHook<hooks::Cushions>) {
            const auto& mouths = set_.template hook<hooks::Cushions>();
            for (const std::size_t i : memory_.loose) {
                const Vec2 v = xy(paths_.drift(i));
                if (v == Vec2{} || !mouths.may_reach(balls_[i], v, time_)) continue;
                const auto hit = mouths.straight_hit(balls_[i], v, time_);
                if (hit && is_first(hit->t))
                    work_.contacts.push_back({Contact::Kind::kRail, i, i, hit->rail, hit->normal});
            }
        }
    }

    const Set& set_;
    const Paths& paths_;
    const Table& table_;
    std::vector<MovingBall>& balls_;
    Workspace& work_;
    SteppingMemory& memory_;
    Real time_ = 0;   ///< looked at, s
    Real first_ = 0;  ///< s
};

}  // namespace poolhall
