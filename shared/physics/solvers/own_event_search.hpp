#pragma once

#include "shared/physics/contact/contact_time.hpp"
#include "shared/physics/search/box.hpp"
#include "shared/physics/search/circle_captures.hpp"
#include "shared/physics/search/own_event.hpp"
#include "shared/physics/search/table_hooks.hpp"

namespace poolhall {

/// Finds the first rail or pocket on a ball's arc. Times inside are from the arc's beginning.
template <class Set>
class OwnEventSearch {
  public:
    /// `reach` is where the ball's surface gets on the whole arc; what is found goes to `event`.
    OwnEventSearch(const Set& set, const MovingBall& ball, const Arc& arc, const Box& reach,
                   OwnEvent& event)
        : set_(set),
          ball_(ball),
          arc_(arc),
          reach_(reach),
          horizon_(arc.until - arc.since),
          event_(event) {
        event_.t = arc.until;
        event_.kind = OwnEvent::Kind::kTransition;
        event_.touch_count = 0;
    }

    void find() {
        if (!moves_centre(ball_.motion)) return;
        if constexpr (Set::template kHook<hooks::StraightRails>)
            find_rails(set_.template hook<hooks::StraightRails>());
        if constexpr (Set::template kHook<hooks::Cushions>)
            find_cushions(set_.template hook<hooks::Cushions>());
        if (ball_.motion != Motion::kAirborne) find_pockets();
    }

  private:
    /// True if something after `dt` s is the first; what is as early as the first so far goes
    /// before it, but for rails, which are met together.
    bool is_first(Real dt, OwnEvent::Kind kind) {
        if (!(dt <= horizon_)) return false;
        const Real t = arc_.since + dt;
        if (t > event_.t || (t == event_.t && event_.kind == OwnEvent::Kind::kTransition))
            return false;
        if (t < event_.t || event_.kind != kind) event_.touch_count = 0;
        event_.t = t;
        event_.kind = kind;
        return true;
    }

    void touch(Real dt, Rail rail, Vec2 normal) {
        if (!is_first(dt, OwnEvent::Kind::kRail)) return;
        if (event_.touch_count < event_.touches.size())
            event_.touches[event_.touch_count++] = {rail, normal};
    }

    /// A piece of a cushion; at the joint of two, which have one normal, only the first counts.
    void touch_first(Real dt, Rail rail, Vec2 normal) {
        if (arc_.since + dt < event_.t) touch(dt, rail, normal);
    }

    /// When v s + a s^2 / 2 (under drag: v s) reaches the gap, s.
    [[nodiscard]] Real time_to(Real gap, Real v, Real a) const {
        const Real t = time_to_close(gap, v, a);
        return arc_.drag > 0 ? time_under_drag(arc_.drag, t) : t;
    }

    /// When what is behind a line, and so has a negative gap, has come before it and is back, s.
    [[nodiscard]] static Real time_back(Real gap, Real v, Real a) {
        const Real square = v * v + 2 * a * gap;
        return v < 0 && a > 0 && square > 0 ? (sqrt(square) - v) / a : kNever;
    }

    void find_rails(const StraightRailEffect auto& rails) {
        const Vec2 edge = rails.edge(ball_.reach);
        const Vec2 nose = rails.edge(0);
        if (reach_.high_x >= nose.x)
            touch(time_to(edge.x - ball_.r.x, ball_.v.x, arc_.a.x), Rail::kEast, {1, 0});
        if (reach_.low_x <= -nose.x)
            touch(time_to(edge.x + ball_.r.x, -ball_.v.x, -arc_.a.x), Rail::kWest, {-1, 0});
        if (reach_.high_y >= nose.y)
            touch(time_to(edge.y - ball_.r.y, ball_.v.y, arc_.a.y), Rail::kNorth, {0, 1});
        if (reach_.low_y <= -nose.y)
            touch(time_to(edge.y + ball_.r.y, -ball_.v.y, -arc_.a.y), Rail::kSouth, {0, -1});
    }

    void find_cushions(const CushionEffect auto& mouths) {
        if (!mouths.may_reach(reach_)) return;
        for (const CushionLine& line : mouths.table().lines()) {
            const Real gap = dot(line.from - ball_.r, line.normal) - ball_.reach;
            const Real closing = dot(ball_.v, line.normal);
            const Real v = abs(closing) <= rounding_of(ball_.v) ? 0 : closing;
            const Real a = dot(arc_.a, line.normal);
            const Real dt = faces(gap) ? time_to(gap, v, a) : time_back(gap, v, a);
            if (dt <= horizon_ && within(line, place_on(ball_, arc_, arc_.since + dt)))
                touch_first(dt, line.rail, line.normal);
        }
        for (const CushionArc& arc : mouths.table().arcs()) {
            const Real dt = time_to_come_within(arc.centre, arc.radius + ball_.reach);
            if (!(dt <= horizon_)) continue;
            const Vec2 out = place_on(ball_, arc_, arc_.since + dt) - arc.centre;
            if (within(arc, out)) touch_first(dt, arc.rail, -normalized(out));
        }
    }

    void find_pockets() {
        set_.for_each([this]<ArcPocketEffect Pockets>(const Pockets& pockets) {
            if (const auto capture = pockets.first_capture_on(ball_, arc_)) take(*capture);
        });
        set_.for_each([this]<CirclePocketEffect Pockets>(const Pockets& pockets) {
            if (!pockets.may_reach(reach_)) return;
            for (std::size_t i = 0; i < pockets.circles().size(); ++i)
                take({time_into(pockets.circles()[i]), pockets.pocket_of(i)});
        });
    }

    void take(const Capture& capture) {
        // Where rail and pocket come at the same instant, the pocket does; of two pockets the
        // first.
        const bool as_early = arc_.since + capture.t == event_.t;
        if (as_early && event_.kind == OwnEvent::Kind::kCapture) return;
        if (as_early && event_.kind == OwnEvent::Kind::kRail) event_.t = kNever;
        if (is_first(capture.t, OwnEvent::Kind::kCapture)) event_.pocket = capture.pocket;
    }

    /// When the ball's centre is in the circle of a pocket, s; 0 where it is from the beginning,
    /// whichever way it goes: it was put there, or comes down there.
    template <class Circle>
    [[nodiscard]] Real time_into(const Circle& circle) const {
        if (is_in_circle(circle, ball_.r)) return 0;
        return time_to_come_within(circle.centre, circle.radius);
    }

    /// When the ball's centre comes within `distance` of a place, s; 0 where it is there already
    /// and does not move away.
    [[nodiscard]] Real time_to_come_within(Vec2 place, Real distance) const {
        // reach_ is wider than the centre's way by the radius at least.
        if (place.x - distance > reach_.high_x || place.x + distance < reach_.low_x ||
            place.y - distance > reach_.high_y || place.y + distance < reach_.low_y)
            return kNever;
        const Vec2 c = ball_.r - place;
        if (dot(c, c) <= distance * distance) {
            const Real approach = -dot(c, ball_.v);
            const Real rounding = distance * rounding_of(ball_.v);
            if (approach > rounding || (approach >= -rounding && dot(c, arc_.a) < 0)) return 0;
            // Only a parabola comes back to what it leaves.
            if (arc_.a == Vec2{} || ball_.motion == Motion::kRolling) return kNever;
        }
        if (arc_.drag > 0)
            return time_under_drag(arc_.drag,
                                   first_contact_straight(c, ball_.v, 0, distance, kNever));
        if (ball_.motion == Motion::kRolling)
            return first_contact_straight(c, ball_.v, norm(arc_.a), distance, horizon_);
        if (stay_apart(c, ball_.v, arc_.a, distance, horizon_)) return kNever;
        return first_contact({c, ball_.v, arc_.a}, distance, horizon_);
    }

    const Set& set_;
    const MovingBall& ball_;
    const Arc& arc_;
    const Box& reach_;
    Real horizon_;
    OwnEvent& event_;
};

}  // namespace poolhall
