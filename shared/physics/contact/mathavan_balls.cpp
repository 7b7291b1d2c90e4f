#include "shared/physics/contact/mathavan_balls.hpp"

#include <algorithm>

namespace poolhall {

namespace {

constexpr int kMostSteps = 1000;
constexpr Real kAtRest = 1e-10;  // a slip as slow as this
constexpr Real kFastest = 1e12;  // a faster slip keeps its direction all the while

/// What has passed between the balls, and between the pressed one and the cloth, or its rate per
/// impulse along n. Vectors have components along n, from the pressed ball to the other, and
/// t = z x n; but `balls` those along t and z.
struct Passed {
    Real normal = 0;
    Vec2 balls;     ///< friction on the other ball
    Vec2 cloth;     ///< friction that the cloth takes from the pressed ball
    Real work = 0;  ///< done by the approach
};

Passed operator+(const Passed& a, const Passed& b) {
    return {a.normal + b.normal, a.balls + b.balls, a.cloth + b.cloth, a.work + b.work};
}

Passed operator*(Real s, const Passed& a) {
    return {s * a.normal, s * a.balls, s * a.cloth, s * a.work};
}

Real largest(const Passed& a) {
    return std::max({abs(a.balls.x), abs(a.balls.y), abs(a.cloth.x), abs(a.cloth.y), abs(a.work)});
}

/// The impulse after which a slip that changes at that rate vanishes, if it aims at zero.
Real until_rest(Vec2 slip, Vec2 rate) {
    constexpr Real kAimed = 0.1;  // sine of the angle by which it misses
    const Real closing = -dot(slip, rate);
    if (!(closing > 0) || abs(cross(slip, rate)) > kAimed * closing) return kInfinity;
    return closing / dot(rate, rate);
}

/// In units of the speed of approach and of the impulse that stops it.
class Impact {
  public:
    /// `share` is that of the other ball in the masses of both; slips at the beginning.
    Impact(const BallsOnCloth& coefficients, Real share, Vec2 balls_slip, Vec2 cloth_slip)
        : tolerance_(coefficients.tolerance),
          mu_(coefficients.mu),
          mu_table_(coefficients.mu_table),
          share_(share),
          balls_slip_(balls_slip),
          cloth_slip_(cloth_slip) {}

    Passed run(Real e) {
        advance_until([this](const Passed& rate) { return approach(at_) / braking(rate); });
        const Real work_at_end = (1 - e * e) * at_.work;
        advance_until([this, work_at_end](const Passed& rate) {
            const Real left = at_.work - work_at_end;
            const Real v = -approach(at_);
            const Real root = sqrt(std::max(Real{0}, v * v + 2 * braking(rate) * left));
            return v + root > 0 ? 2 * left / (v + root) : 0;
        });
        return at_;
    }

  private:
    struct Step {
        Passed change;
        Real error;
    };

    /// A step whose error is not looked at.
    [[nodiscard]] Real shortest() const { return 0.1 * tolerance_; }

    [[nodiscard]] Real approach(const Passed& at) const {
        return 1 - at.normal - share_ * at.cloth.x;
    }

    /// How fast the approach falls.
    [[nodiscard]] Real braking(const Passed& rate) const {
        return rate.normal + share_ * rate.cloth.x;
    }

    /// Changes of the slip of the pressed ball on the other, along t and z, and on the cloth.
    [[nodiscard]] Vec2 change_of_balls_slip(const Passed& p) const {
        return {-3.5 * p.balls.x - share_ * p.cloth.y, -2.5 * (p.balls.y + share_ * p.cloth.x)};
    }

    [[nodiscard]] Vec2 change_of_cloth_slip(const Passed& p) const {
        return -share_ *
               Vec2{p.normal + 2.5 * p.balls.y + 3.5 * p.cloth.x, p.balls.x + 3.5 * p.cloth.y};
    }

    [[nodiscard]] Passed rates(const Passed& at) const {
        Passed rate{1, {}, {}, approach(at)};
        const Vec2 slip = balls_slip_ + change_of_balls_slip(at);
        const Real speed = norm(slip);
        // Nothing but friction changes it: it does not slip again.
        if (speed <= kAtRest) return rate;
        rate.balls = (mu_ / speed) * slip;
        rate.cloth = cloth_friction(cloth_slip_ + change_of_cloth_slip(at), rate);
        return rate;
    }

    /// Of the load that the friction between the balls makes.
    [[nodiscard]] Vec2 cloth_friction(Vec2 slip, const Passed& rate) const {
        const Real most = mu_table_ * std::max(Real{0}, rate.balls.y);
        const Real speed = norm(slip);
        if (speed > kAtRest) return (most / speed) * slip;
        const Vec2 holds = 1 / (3.5 * share_) * change_of_cloth_slip(rate);
        const Real needed = norm(holds);
        return needed <= most ? holds : (most / needed) * holds;
    }

    /// On to where `until_end(rate)` says that no impulse is left.
    template <class UntilEnd>
    void advance_until(UntilEnd until_end) {
        for (; steps_ < kMostSteps; ++steps_) {
            const Passed rate = rates(at_);
            const Real end = until_end(rate);
            if (abs(end) <= shortest()) {
                at_ = at_ + end * rate;
                return;
            }
            try_step(rate, std::min({end, step_, rest_of_slips(rate)}));
        }
        // Never seen: what is left goes without friction.
        const Passed rate{1, {}, {}, approach(at_)};
        at_ = at_ + until_end(rate) * rate;
    }

    [[nodiscard]] Real rest_of_slips(const Passed& rate) const {
        const Vec2 balls = balls_slip_ + change_of_balls_slip(at_);
        const Vec2 cloth = cloth_slip_ + change_of_cloth_slip(at_);
        const Real first =
            norm(balls) > kAtRest ? until_rest(balls, change_of_balls_slip(rate)) : kInfinity;
        if (!(norm(cloth) > kAtRest)) return first;
        return std::min(first, until_rest(cloth, change_of_cloth_slip(rate)));
    }

    void try_step(const Passed& rate, Real h) {
        const Step step = dormand_prince(rate, h);
        const Real size = abs(h);
        const Real fit = sqrt(sqrt(tolerance_ / std::max(step.error, Real{1e-30})));
        const Real next = size * std::clamp(0.65 * fit, Real{0.1}, Real{5});
        if (size > shortest() && step.error > tolerance_) {
            step_ = next;
            return;
        }
        step_ = h < step_ ? std::max(next, step_) : next;
        at_ = at_ + step.change;
    }

    [[nodiscard]] Step dormand_prince(const Passed& k1, Real h) const;

    Real tolerance_;
    Real mu_;
    Real mu_table_;
    Real share_;
    Vec2 balls_slip_;
    Vec2 cloth_slip_;
    Passed at_;
    Real step_ = 1;
    int steps_ = 0;
};

consteval Real ratio(int p, int q) {
    return static_cast<Real>(p) / q;
}

/// Dormand, Prince 1980, "A family of embedded Runge-Kutta formulae", RK5(4)7M.
Impact::Step Impact::dormand_prince(const Passed& k1, Real h) const {
    const auto after = [&](const Passed& change) { return rates(at_ + h * change); };
    const Passed k2 = after(ratio(1, 5) * k1);
    const Passed k3 = after(ratio(3, 40) * k1 + ratio(9, 40) * k2);
    const Passed k4 = after(ratio(44, 45) * k1 + ratio(-56, 15) * k2 + ratio(32, 9) * k3);
    const Passed k5 = after(ratio(19372, 6561) * k1 + ratio(-25360, 2187) * k2 +
                            ratio(64448, 6561) * k3 + ratio(-212, 729) * k4);
    const Passed k6 =
        after(ratio(9017, 3168) * k1 + ratio(-355, 33) * k2 + ratio(46732, 5247) * k3 +
              ratio(49, 176) * k4 + ratio(-5103, 18656) * k5);
    const Passed mean = ratio(35, 384) * k1 + ratio(500, 1113) * k3 + ratio(125, 192) * k4 +
                        ratio(-2187, 6784) * k5 + ratio(11, 84) * k6;
    const Passed k7 = after(mean);
    const Passed error = ratio(71, 57600) * k1 + ratio(-71, 16695) * k3 + ratio(71, 1920) * k4 +
                         ratio(-17253, 339200) * k5 + ratio(22, 525) * k6 + ratio(-1, 40) * k7;
    return {h * mean, abs(h) * largest(error)};
}

/// A slip in units of the approach, without what makes no difference.
Vec2 scaled(Vec2 slip, Real approach) {
    const Real speed = norm(slip);
    if (speed > kFastest * approach) return (kFastest / speed) * slip;
    return {slip.x / approach, slip.y / approach};
}

/// Of two balls of which the first is pressed on the cloth, n pointing to the second.
void collide_pressed(const BallsOnCloth& coefficients, Vec2 n, ImpactBall& pressed,
                     ImpactBall& other) {
    const Vec2 t{-n.y, n.x};
    const Real approach = dot(xy(pressed.v) - xy(other.v), n);
    const Vec2 turn = pressed.radius * xy(pressed.w) + other.radius * xy(other.w);
    const Vec2 balls_slip{dot(xy(pressed.v) - xy(other.v), t) +
                              (pressed.radius * pressed.w.z + other.radius * other.w.z),
                          -dot(turn, t)};
    const Vec2 cloth_slip{dot(xy(pressed.v), n) - pressed.radius * dot(xy(pressed.w), t),
                          dot(xy(pressed.v), t) + pressed.radius * dot(xy(pressed.w), n)};
    const Real masses = pressed.mass + other.mass;
    const Passed unit = Impact(coefficients, other.mass / masses, scaled(balls_slip, approach),
                               scaled(cloth_slip, approach))
                            .run(coefficients.e);
    const Passed impulse = approach * (pressed.mass * other.mass / masses) * unit;

    const Vec2 push = impulse.normal * n + impulse.balls.x * t;
    const Vec2 rub = impulse.cloth.x * n + impulse.cloth.y * t;
    const Vec3 torque{impulse.balls.y * t.x, impulse.balls.y * t.y, -impulse.balls.x};
    const Vec2 cloth_torque = impulse.cloth.x * t - impulse.cloth.y * n;
    set_xy(pressed.v, xy(pressed.v) - 1 / pressed.mass * (push + rub));
    set_xy(other.v, xy(other.v) + 1 / other.mass * push);
    pressed.w = pressed.w + 2.5 / (pressed.mass * pressed.radius) *
                                (torque + Vec3{cloth_torque.x, cloth_torque.y, 0});
    other.w = other.w + 2.5 / (other.mass * other.radius) * torque;
}

}  // namespace

void collide_mathavan2014(const BallsOnCloth& coefficients, Vec3 n, ImpactBall& a, ImpactBall& b) {
    // The surface that moves up pushes the other ball up and its own down.
    if (slip_velocity(n, a, b).z < 0)
        collide_pressed(coefficients, -xy(n), b, a);
    else
        collide_pressed(coefficients, xy(n), a, b);
}

}  // namespace poolhall
