#pragma once

#include "shared/physics/motion/cloth.hpp"
#include "shared/physics/motion/moving_ball.hpp"
#include "shared/physics/scene/scene.hpp"
#include "shared/physics/solvers/with_kernel.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

// A tick of explicit Euler for balls that meet nothing, as somebody writes it who wants just some
// effects and knows no kernels: one loop each, constants ahead of it. `ended` counts slides, rolls,
// spins and flights that end. kernel_steps.cpp compares the kernels with these.
namespace poolhall::hand_written {

inline void glide(MovingBall& ball, double dt) {
    ball.r = ball.r + dt * ball.v;
}

/// No effect that acts on a ball by itself.
class Glide {
  public:
    explicit Glide(const Scene& /*scene*/) {}

    void tick(std::span<MovingBall> balls, double dt, std::size_t& /*ended*/) const {
        for (MovingBall& ball : balls)
            glide(ball, dt);
    }
};

/// Linear drag.
class Drag {
  public:
    explicit Drag(const Scene& scene)
        : k_(scene.effects.linear_drag->k), stop_speed_(scene.effects.linear_drag->stop_speed) {}

    void tick(std::span<MovingBall> balls, double dt, std::size_t& ended) const {
        const double keep = 1 - k_ * dt;
        const double least = stop_speed_ * stop_speed_;
        for (MovingBall& ball : balls) {
            glide(ball, dt);
            if (ball.motion != Motion::kRolling) continue;
            ball.v = keep * ball.v;
            if (dot(ball.v, ball.v) >= least) continue;
            ball.v = {};
            ball.motion = Motion::kStationary;
            ++ended;
        }
    }

  private:
    double k_;           ///< 1/s
    double stop_speed_;  ///< m/s
};

/// Takes `lost` (m/s) from the speed of a ball that rolls. True where it stops.
inline bool slow_down(MovingBall& ball, double lost) {
    const double speed = std::sqrt(dot(ball.v, ball.v));
    if (speed > lost) {
        ball.v = ball.v - (lost / speed) * ball.v;
        return false;
    }
    ball.v = {};
    return true;
}

/// Rolling resistance.
class Roll {
  public:
    explicit Roll(const Scene& scene) : mu_g_(scene.effects.rolling->mu * scene.gravity) {}

    void tick(std::span<MovingBall> balls, double dt, std::size_t& ended) const {
        const double lost = mu_g_ * dt;
        for (MovingBall& ball : balls) {
            glide(ball, dt);
            if (ball.motion != Motion::kRolling || !slow_down(ball, lost)) continue;
            ball.motion = Motion::kStationary;
            ++ended;
        }
    }

  private:
    double mu_g_;  ///< m/s^2
};

/// Friction takes `lost` (m/s) from the speed of a ball that slides, and turns it. True where the
/// slide ends; the ball rolls then.
inline bool rub(MovingBall& ball, double lost) {
    const double radius = ball.radius;
    const Vec2 slip{ball.v.x - radius * ball.w.y, ball.v.y + radius * ball.w.x};
    const double speed = std::sqrt(dot(slip, slip));
    if (2 * speed > 7 * lost) {
        const Vec2 impulse = (lost / speed) * slip;
        const double turn = 5 / (2 * radius);
        ball.v = ball.v - impulse;
        ball.w.x = ball.w.x - turn * impulse.y;
        ball.w.y = ball.w.y + turn * impulse.x;
        return false;
    }
    ball.v = ball.v - (2.0 / 7) * slip;
    ball.w.x = -ball.v.y / radius;
    ball.w.y = ball.v.x / radius;
    ball.motion = Motion::kRolling;
    return true;
}

/// Takes from the spin about the vertical axis what friction takes in dt s. True where it ends.
inline bool spin_down(MovingBall& ball, double mu_g, double dt) {
    const double lost = 5 * mu_g / (2 * ball.radius) * dt;
    const double spin = ball.w.z;
    if (spin > lost) {
        ball.w.z = spin - lost;
        return false;
    }
    if (spin < -lost) {
        ball.w.z = spin + lost;
        return false;
    }
    ball.w.z = 0;
    return true;
}

/// Friction of the cloth on slips, and rolling resistance.
class SlideRoll {
  public:
    explicit SlideRoll(const Scene& scene)
        : sliding_(scene.effects.sliding->mu * scene.gravity),
          rolling_(scene.effects.rolling->mu * scene.gravity) {}

    void tick(std::span<MovingBall> balls, double dt, std::size_t& ended) const {
        const double rubbed = sliding_ * dt;
        const double slowed = rolling_ * dt;
        for (MovingBall& ball : balls) {
            glide(ball, dt);
            if (ball.motion == Motion::kRolling) {
                if (!slow_down(ball, slowed)) continue;
                set_xy(ball.w, {});
                ball.motion = Motion::kStationary;
                ++ended;
            } else if (ball.motion == Motion::kSliding) {
                if (rub(ball, rubbed)) ++ended;
            }
        }
    }

  private:
    double sliding_;  ///< m/s^2
    double rolling_;  ///< m/s^2
};

/// The same with friction on spin about the vertical axis.
class SlideRollSpin {
  public:
    explicit SlideRollSpin(const Scene& scene)
        : sliding_(scene.effects.sliding->mu * scene.gravity),
          rolling_(scene.effects.rolling->mu * scene.gravity),
          spinning_(scene.effects.spin_decay->mu * scene.gravity) {}

    void tick(std::span<MovingBall> balls, double dt, std::size_t& ended) const {
        const double rubbed = sliding_ * dt;
        const double slowed = rolling_ * dt;
        for (MovingBall& ball : balls) {
            glide(ball, dt);
            if (ball.motion == Motion::kRolling) {
                if (slow_down(ball, slowed)) {
                    set_xy(ball.w, {});
                    ball.motion = ball.w.z != 0 ? Motion::kSpinning : Motion::kStationary;
                    ++ended;
                }
            } else if (ball.motion == Motion::kSliding) {
                if (rub(ball, rubbed)) ++ended;
            }
            if (ball.w.z == 0 || !spin_down(ball, spinning_, dt)) continue;
            if (ball.motion != Motion::kSpinning) continue;
            ball.motion = Motion::kStationary;
            ++ended;
        }
    }

  private:
    double sliding_;   ///< m/s^2
    double rolling_;   ///< m/s^2
    double spinning_;  ///< m/s^2
};

/// All effects that there are. What a bounce does is the library's own: it is rare, and long.
class Everything {
  public:
    explicit Everything(const Scene& scene)
        : kernel_(KernelScene(scene, cushions_)),
          cloth_(kernel_, scene.gravity),
          sliding_(scene.effects.sliding->mu * scene.gravity),
          rolling_(scene.effects.rolling->mu * scene.gravity),
          spinning_(scene.effects.spin_decay->mu * scene.gravity),
          k_(scene.effects.linear_drag->k),
          stop_speed_(scene.effects.linear_drag->stop_speed) {}

    void tick(std::span<MovingBall> balls, double dt, std::size_t& ended) const {
        const double rubbed = sliding_ * dt;
        const double slowed = rolling_ * dt;
        const double keep = 1 - k_ * dt;
        const double least = stop_speed_ * stop_speed_;
        for (MovingBall& ball : balls) {
            glide(ball, dt);
            ball.height = ball.height + dt * ball.climb;
            if (ball.motion == Motion::kRolling) {
                if (slow_down(ball, slowed)) stop(ball, ended);
            } else if (ball.motion == Motion::kSliding) {
                if (rub(ball, rubbed)) ++ended;
            } else if (ball.motion == Motion::kAirborne) {
                if (kernel_.effect<Airborne>().step_flight(ball, dt)) {
                    cloth_.settle(ball);
                    ++ended;
                }
            }
            if (ball.motion != Motion::kAirborne && ball.w.z != 0 &&
                spin_down(ball, spinning_, dt) && ball.motion == Motion::kSpinning) {
                ball.motion = Motion::kStationary;
                ++ended;
            }
            if (ball.v == Vec2{}) continue;
            ball.v = keep * ball.v;
            if (dot(ball.v, ball.v) < least) stop(ball, ended);
        }
    }

  private:
    static void stop(MovingBall& ball, std::size_t& ended) {
        ball.v = {};
        set_xy(ball.w, {});
        ball.motion = ball.w.z != 0 ? Motion::kSpinning : Motion::kStationary;
        ++ended;
    }

    KeptCushionMap cushions_;
    poolhall::Everything kernel_;
    Cloth<poolhall::Everything> cloth_;
    double sliding_;     ///< m/s^2
    double rolling_;     ///< m/s^2
    double spinning_;    ///< m/s^2
    double k_;           ///< 1/s
    double stop_speed_;  ///< m/s
};

}  // namespace poolhall::hand_written
