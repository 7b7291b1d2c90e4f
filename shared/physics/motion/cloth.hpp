#pragma once

#include "shared/physics/motion/arc.hpp"
#include "shared/physics/motion/cloth_hooks.hpp"
#include "shared/physics/motion/event_kind.hpp"
#include "shared/physics/motion/slip.hpp"

#include <span>

namespace poolhall {

/// What the cloth does to a ball between impacts: slide, roll, spin, rest. `Set`, an EffectSet
/// (effect_set.hpp), says by which hooks (cloth_hooks.hpp); others leave no instruction behind. The
/// spin about the horizontal axes of a ball that rolls follows from its velocity and is brought up
/// to date by settle().
template <class Set>
class Cloth {
  public:
    Cloth(const Set& effects, Real gravity) : effects_(effects), gravity_(gravity) {}

    /// Decides how the ball moves on from its r, v and w: after a strike, an impact, a bounce.
    void settle(MovingBall& ball) const {
        if constexpr (Set::template kHook<hooks::Flight>) {
            if (effects_.template hook<hooks::Flight>().in_air(ball)) {
                ball.motion = Motion::kAirborne;
                return;
            }
        }
        if (slides(ball)) {
            ball.motion = Motion::kSliding;
        } else {
            roll(ball);
        }
    }

    /// A step of explicit Euler, as far as it is the same for all balls.
    struct Step {
        Real dt = 0;      ///< s
        Real rolled = 0;  ///< what a ball that rolls loses of its speed, m/s
        Real slid = 0;    ///< what friction takes from one that slides, m/s
        Real kept = 1;    ///< the share of their velocity that drag leaves them
    };

    [[nodiscard]] Step step_of(Real dt) const {
        Step step{dt};
        if constexpr (Set::template kHook<hooks::Roll>)
            step.rolled = effects_.template hook<hooks::Roll>().roll_loss(dt);
        if constexpr (Set::template kHook<hooks::Slip>)
            step.slid = effects_.template hook<hooks::Slip>().slip_loss(dt);
        if constexpr (Set::template kHook<hooks::Drag>)
            step.kept = effects_.template hook<hooks::Drag>().drag_keeps(dt);
        return step;
    }

    /// Takes the step; `happened(kind, before)` hears of what ended with it.
    template <class Happened>
    void kick(MovingBall& ball, const Step& step, const Happened& happened) const {
        // Rebuilt where something happens: a copy a step would cost more than the step.
        const Vec2 v = ball.v;
        const Motion motion = ball.motion;
        if constexpr (Set::template kHook<hooks::Roll>) {
            if (motion == Motion::kRolling &&
                effects_.template hook<hooks::Roll>().step_roll(ball, step.rolled)) [[unlikely]]
                end_roll(ball, v, happened);
        }
        if constexpr (Set::template kHook<hooks::Slip>) {
            if (motion == Motion::kSliding &&
                effects_.template hook<hooks::Slip>().step_slip(ball, step.slid)) [[unlikely]]
                end_slide(ball, v, happened);
        }
        if constexpr (Set::template kHook<hooks::Flight>) {
            if (motion == Motion::kAirborne) [[unlikely]]
                kick_in_air(ball, step.dt, happened);
        }
        if constexpr (Set::template kHook<hooks::Spin>) kick_side_spin(ball, step.dt, happened);
        if constexpr (Set::template kHook<hooks::Drag>) kick_drag(ball, step.kept, happened);
        effects_.for_each(
            [&]<ForceEffect Force>(const Force& force) { force.push(ball, step.dt); });
    }

    /// The closed-form motion of a settled ball from time t on.
    [[nodiscard]] Arc arc_of(const MovingBall& ball, Real t) const {
        Arc arc;
        find_arc(ball, t, arc);
        return arc;
    }

    void find_arc(const MovingBall& ball, Real t, Arc& arc) const {
        arc = Arc{};
        arc.since = t;
        if constexpr (Set::template kHook<hooks::Spin>) {
            if (ball.motion != Motion::kAirborne)
                arc.side_decay =
                    effects_.template hook<hooks::Spin>().spin_deceleration(ball.radius);
        }
        switch (ball.motion) {
            case Motion::kSliding:
                if constexpr (Set::template kHook<hooks::Slip>) slide(ball, arc);
                break;
            case Motion::kRolling:
                if constexpr (Set::template kHook<hooks::Roll>) decelerate(ball, arc);
                if constexpr (Set::template kHook<hooks::Drag>) drag(ball, arc);
                break;
            case Motion::kSpinning:
                arc.until = t + abs(ball.w.z) / arc.side_decay;
                break;
            case Motion::kAirborne:
                if constexpr (Set::template kHook<hooks::Flight>) fly(ball, arc);
                break;
            default:
                break;
        }
    }

    /// The ball at arc.until, where its motion ends by itself, settled anew.
    template <class Happened>
    void transition(MovingBall& ball, const Arc& arc, Happened happened) const {
        const Motion motion = ball.motion;
        const Vec2 r = ball.r;
        const Vec2 v = ball.v;
        // A full draw leaves nothing but rounding of what it had.
        const Vec2 rolled = motion == Motion::kSliding
                                ? unless_rounding(velocity_after_slip(v, slip_of(ball)), ball)
                                : Vec2{};
        advance(ball, arc, arc.until);
        const MovingBall before = ball;
        switch (motion) {
            case Motion::kSliding:
                // Exactly, rather than what the arc makes of it.
                ball.v = rolled;
                roll(ball);
                happened(EventKind::kSlideToRoll, before);
                if (ball.motion != Motion::kRolling) happened(EventKind::kRollToRest, before);
                break;
            case Motion::kRolling:
                // The mean velocity, rather than the arc's end, which cancels.
                if (arc.drag == 0) ball.r = r + ((arc.until - arc.since) / 2) * v;
                stop(ball);
                happened(EventKind::kRollToRest, before);
                break;
            case Motion::kAirborne:
                if constexpr (Set::template kHook<hooks::Flight>) {
                    ball.height = 0;
                    effects_.template hook<hooks::Flight>().bounce(ball);
                    settle(ball);
                    happened(EventKind::kBounce, before);
                }
                break;
            default:
                ball.w.z = 0;
                ball.motion = Motion::kStationary;
                happened(EventKind::kSpinToRest, before);
                break;
        }
    }

    /// Makes the spin of a ball that rolls follow its velocity.
    void update_spin(MovingBall& ball) const {
        if (ball.motion == Motion::kRolling && couples_spin())
            set_xy(ball.w, rolling_spin(ball.v, ball.radius));
    }

    void update_spins(std::span<MovingBall> balls) const {
        for (MovingBall& ball : balls)
            update_spin(ball);
    }

  private:
    /// Slips and velocities below this share of what they were made of are rounding.
    static constexpr Real kRounding = 4 * kEpsilon;

    /// The ball as it was before its velocity, and a spin that follows from it, changed.
    [[nodiscard]] MovingBall with_velocity(MovingBall ball, Vec2 v) const {
        ball.v = v;
        update_spin(ball);
        return ball;
    }

    [[nodiscard]] bool couples_spin() const {
        if constexpr (Set::template kHook<hooks::Slip>)
            return effects_.template hook<hooks::Slip>().rubs();
        return false;
    }

    /// Whether a speed is more than rounding of what the ball's motion is made of.
    [[nodiscard]] static bool exceeds_rounding(Vec2 speed, const MovingBall& ball) {
        // (|v| + R |w|)^2 <= 2 (v^2 + R^2 w^2): mostly it takes no root.
        const Real reach = ball.radius * ball.radius;
        const Real squares = dot(ball.v, ball.v) + reach * dot(xy(ball.w), xy(ball.w));
        if (dot(speed, speed) > 4 * kRounding * kRounding * squares) return true;
        return length(speed) > kRounding * (length(ball.v) + ball.radius * length(xy(ball.w)));
    }

    [[nodiscard]] static Vec2 unless_rounding(Vec2 v, const MovingBall& ball) {
        return exceeds_rounding(v, ball) ? v : Vec2{};
    }

    [[nodiscard]] bool slides(const MovingBall& ball) const {
        return couples_spin() && exceeds_rounding(slip_of(ball), ball);
    }

    void roll(MovingBall& ball) const {
        if (ball.v == Vec2{}) {
            stop(ball);
            return;
        }
        ball.motion = Motion::kRolling;
        update_spin(ball);
    }

    void stop(MovingBall& ball) const {
        ball.v = {};
        if (couples_spin()) set_xy(ball.w, {});
        ball.motion = Motion::kStationary;
        if constexpr (Set::template kHook<hooks::Spin>) {
            if (ball.w.z != 0 && effects_.template hook<hooks::Spin>().ends_spin())
                ball.motion = Motion::kSpinning;
        }
    }

    /// A slide that began the step with velocity v has come to its end.
    template <class Happened>
    void end_slide(MovingBall& ball, Vec2 v, const Happened& happened) const {
        const MovingBall before = with_velocity(ball, v);
        ball.v = unless_rounding(ball.v, before);
        roll(ball);
        happened(EventKind::kSlideToRoll, before);
        if (ball.motion != Motion::kRolling) happened(EventKind::kRollToRest, before);
    }

    template <class Happened>
    void end_roll(MovingBall& ball, Vec2 v, const Happened& happened) const {
        const MovingBall before = with_velocity(ball, v);
        stop(ball);
        happened(EventKind::kRollToRest, before);
    }

    template <class Happened>
    void kick_in_air(MovingBall& ball, Real dt, const Happened& happened) const {
        const MovingBall before = ball;
        if (!effects_.template hook<hooks::Flight>().step_flight(ball, dt)) return;
        settle(ball);
        happened(EventKind::kBounce, before);
    }

    template <class Happened>
    void kick_side_spin(MovingBall& ball, Real dt, const Happened& happened) const {
        if constexpr (Set::template kHook<hooks::Flight>) {
            if (ball.motion == Motion::kAirborne) return;
        }
        if (ball.w.z == 0) return;
        const Real spin = ball.w.z;
        const bool ended = effects_.template hook<hooks::Spin>().step_spin(ball, dt);
        if (ended && ball.motion == Motion::kSpinning) [[unlikely]] {
            MovingBall before = ball;
            before.w.z = spin;
            ball.motion = Motion::kStationary;
            happened(EventKind::kSpinToRest, before);
        }
    }

    template <class Happened>
    void kick_drag(MovingBall& ball, Real kept, const Happened& happened) const {
        if (!moves_on(ball)) return;
        const Vec2 v = ball.v;
        if (effects_.template hook<hooks::Drag>().step_drag(ball, kept)) [[unlikely]]
            end_roll(ball, v, happened);
    }

    /// Whether its centre moves. Balls that only roll are at rest when they do not.
    [[nodiscard]] static bool moves_on(const MovingBall& ball) {
        constexpr bool kSlides = Set::template kHook<hooks::Slip>;
        constexpr bool kFlies = Set::template kHook<hooks::Flight>;
        return kSlides || kFlies ? ball.v != Vec2{} : ball.motion == Motion::kRolling;
    }

    void slide(const MovingBall& ball, Arc& arc) const {
        const auto& friction = effects_.template hook<hooks::Slip>();
        const Vec2 slip = slip_of(ball);
        const Real speed = length(slip);
        const Vec2 along{slip.x / speed, slip.y / speed};
        arc.a = -friction.slip_deceleration() * along;
        arc.dw = friction.slip_spin_rate(along, ball.radius);
        arc.until = arc.since + friction.slip_time(speed);
    }

    void decelerate(const MovingBall& ball, Arc& arc) const {
        const Real deceleration = effects_.template hook<hooks::Roll>().roll_deceleration();
        if (deceleration == 0) return;
        const Real speed = length(ball.v);
        arc.a = -deceleration * Vec2{ball.v.x / speed, ball.v.y / speed};
        if (couples_spin()) arc.dw = rolling_spin(arc.a, ball.radius);
        arc.until = arc.since + speed / deceleration;
    }

    void drag(const MovingBall& ball, Arc& arc) const {
        const auto& drag = effects_.template hook<hooks::Drag>();
        if (drag.drag_rate() == 0) return;
        arc.drag = drag.drag_rate();
        arc.until = arc.since + drag.drag_time(norm(ball.v));
    }

    void fly(const MovingBall& ball, Arc& arc) const {
        arc.gravity = gravity_;
        arc.until = arc.since + effects_.template hook<hooks::Flight>().time_to_slate(ball);
    }

    const Set& effects_;
    Real gravity_;
};

}  // namespace poolhall
