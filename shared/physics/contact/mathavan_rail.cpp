#include "shared/physics/contact/mathavan_rail.hpp"

#include "shared/physics/contact/rail_frame.hpp"
#include "shared/physics/contact/rail_friction.hpp"

#include <algorithm>

namespace poolhall {
namespace {

using Forces = RailFriction::Forces;

constexpr int kPatience = 150;    // steps of a phase; with mu up to 0.4 few take more
constexpr int kMostSteps = 1000;  // of a phase

/// How far an impact is, in units of the speed of approach, the mass being 1. Also its derivative.
struct Progress {
    Real normal = 0;  ///< impulse of the nose
    Forces friction;  ///< impulses
    Real work = 0;    ///< done on the nose
};

Forces operator+(const Forces& a, const Forces& b) {
    return {a.nose + b.nose, a.cloth + b.cloth};
}

Progress operator+(const Progress& a, const Progress& b) {
    return {a.normal + b.normal, a.friction + b.friction, a.work + b.work};
}

Progress operator*(Real s, const Progress& a) {
    return {s * a.normal, {s * a.friction.nose, s * a.friction.cloth}, s * a.work};
}

Real largest(const Progress& a) {
    return std::max({abs(a.normal), abs(a.friction.nose.x), abs(a.friction.nose.y),
                     abs(a.friction.cloth.x), abs(a.friction.cloth.y), abs(a.work)});
}

/// A contact at which the ball may slip: slip = start + unit * change, in a scale of its own, so
/// that a ball that grazes the rail at 1e-300 of its speed loses nothing.
class SlidingContact {
  public:
    SlidingContact(Vec2 slip, Real approach, Real mu) : slips_(mu > 0) {
        const Real scale = std::max({abs(slip.x), abs(slip.y), approach});
        start_ = {slip.x / scale, slip.y / scale};
        unit_ = approach / scale;
    }

    [[nodiscard]] bool at_rest() const { return at_rest_; }

    void set_at_rest(bool at_rest) { at_rest_ = at_rest; }

    /// The direction of the last slip that could be told from rounding.
    [[nodiscard]] Vec2 last_direction() const { return direction_; }

    [[nodiscard]] bool slower_than(Real speed, Vec2 change) const {
        const Vec2 now = slip(change);
        return slips_ && dot(now, now) <= speed * unit_ * speed * unit_;
    }

    /// Whether there is no slip that could be told from rounding, or one all but along that.
    [[nodiscard]] bool sets_out_in(Vec2 direction, Vec2 change) const {
        constexpr Real kAligned = 0.01;
        const Vec2 now = slip(change);
        return slower_than(kRounding, change) ||
               (dot(now, direction) > 0 &&
                abs(cross(now, direction)) < kAligned * dot(now, direction));
    }

    /// In units of the approach, of a slow slip.
    [[nodiscard]] Vec2 slow_slip(Vec2 change) const { return (1 / unit_) * slip(change); }

    /// Where the slip all but vanishes, its last direction, so that a step may end in rest.
    [[nodiscard]] Vec2 direction(Vec2 change) const {
        const Vec2 now = slip(change);
        const Real square = dot(now, now);
        return square > kRounding * unit_ * kRounding * unit_ ? (1 / sqrt(square)) * now
                                                              : direction_;
    }

    /// To be called between steps.
    void remember_direction(Vec2 change) { direction_ = direction(change); }

    /// The impulse after which the slip vanishes, if it goes on to change at that rate; nothing if
    /// it passes zero at a distance.
    [[nodiscard]] Real until_rest(Vec2 change, Vec2 rate) const {
        constexpr Real kAimed = 0.1;  // sine of the angle by which it misses
        const Vec2 now = slip(change);
        const Real closing = -dot(now, rate);
        if (at_rest_ || !slips_ || !(closing > 0)) return kInfinity;
        if (abs(cross(now, rate)) > kAimed * closing) return kInfinity;
        return closing / dot(rate, rate) / unit_;
    }

  private:
    static constexpr Real kRounding = 1e-12;

    [[nodiscard]] Vec2 slip(Vec2 change) const { return start_ + unit_ * change; }

    Vec2 start_;
    Real unit_ = 1;
    Vec2 direction_;
    bool slips_;
    bool at_rest_ = false;
};

/// An impact as an initial value problem in the nose's normal impulse.
class Impact {
  public:
    Impact(const RailContact& rail, const BallAtRail& ball, const ImpactPrecision& precision)
        : precision_(precision),
          cos_theta_(ball.cos_theta),
          friction_(ball.sin_theta, ball.cos_theta, rail.mu, rail.mu_table),
          nose_(ball.nose_slip(), ball.v.y, rail.mu),
          cloth_(ball.cloth_slip(), ball.v.y, rail.mu_table) {}

    /// The impulses of the whole impact, in units of the speed of approach.
    RailImpulse run(Real e) {
        settle();
        rate_ = rates(at_);
        if (run_phase(&Impact::until_compressed)) {
            work_at_end_ = (1 - e * e) * at_.work;
            run_phase(&Impact::until_restored);
        }
        return {at_.normal, at_.friction.nose, at_.friction.cloth};
    }

  private:
    struct Step {
        Progress change;
        Progress rate;  // at its end
        Real error;
    };

    using UntilEnd = Real (Impact::*)(const Progress&) const;

    [[nodiscard]] Real approach(const Progress& at) const {
        return 1 + friction_.approach(at.normal, at.friction);
    }

    [[nodiscard]] Vec2 nose_slip(const Progress& at) const {
        return friction_.nose_slip(at.normal, at.friction);
    }

    [[nodiscard]] Vec2 cloth_slip(const Progress& at) const {
        return friction_.cloth_slip(at.normal, at.friction);
    }

    [[nodiscard]] Progress rates(const Progress& at) const {
        return {1, forces(at), cos_theta_ * approach(at)};
    }

    [[nodiscard]] Forces forces(const Progress& at) const {
        if (nose_.at_rest()) return friction_.nose_at_rest(cloth_.direction(cloth_slip(at)));
        const Vec2 nose = nose_.direction(nose_slip(at));
        if (cloth_.at_rest()) return friction_.cloth_at_rest(nose);
        return friction_.slipping(nose, cloth_.direction(cloth_slip(at)));
    }

    /// The impulse that stops the approach, at the present rates; negative if it is past.
    [[nodiscard]] Real until_compressed(const Progress& rate) const {
        const Real braking = -friction_.approach(1, rate.friction);
        const Real v = approach(at_);
        return braking > 0 ? v / braking : v > 0 ? kInfinity : 0;
    }

    /// The impulse after which the nose has given back its work; 0 if it cannot push the ball away.
    [[nodiscard]] Real until_restored(const Progress& rate) const {
        const Real left = at_.work - work_at_end_;
        const Real pushing = -cos_theta_ * friction_.approach(1, rate.friction);
        const Real v = -cos_theta_ * approach(at_);
        const Real root = sqrt(std::max(Real{0}, v * v + 2 * pushing * left));
        return v + root > 0 ? 2 * left / (v + root) : 0;
    }

    [[nodiscard]] Real until_rest(const Progress& rate) const {
        return std::min(nose_.until_rest(nose_slip(at_), nose_slip(rate)),
                        cloth_.until_rest(cloth_slip(at_), cloth_slip(rate)));
    }

    /// Where a slip creeps for long at all but no speed, precision gives way to a bounded cost.
    void coarsen() {
        precision_.tolerance = std::min(Real{1e-3}, 10 * precision_.tolerance);
        precision_.rest_slip = std::min(Real{1e-3}, 10 * precision_.rest_slip);
    }

    [[nodiscard]] bool wedged() const {
        return friction_.wedges() && nose_.at_rest() &&
               cloth_.slower_than(precision_.rest_slip, cloth_slip(at_));
    }

    /// False if it did not come to its end: where the ball is wedged, or friction near 1 on both
    /// sides lets it creep. Then it stays at the rail.
    bool run_phase(UntilEnd until_end) {
        const Real close = std::max(Real{1e-10}, precision_.rest_slip * precision_.rest_slip);
        for (int i = 0; i < kMostSteps && !wedged(); ++i) {
            const Real end = (this->*until_end)(rate_);
            if (abs(end) <= close) {
                advance(end * rate_);
                rate_ = rates(at_);
                return true;
            }
            if (i % kPatience == kPatience - 1) coarsen();
            try_step(std::min(end, until_rest(rate_)));
        }
        return false;
    }

    /// A step of at most that impulse, or nothing but a shorter step for the next time.
    void try_step(Real limit) {
        constexpr Real kShortest = 1e-12;
        const Real h = std::min({limit, step_, precision_.longest_step});
        const Step step = dormand_prince(h);
        const Real size = abs(h);
        const Real fit = sqrt(sqrt(precision_.tolerance / std::max(step.error, Real{1e-30})));
        const Real next = size * std::clamp(0.65 * fit, Real{0.1}, Real{5});
        if (size > kShortest && leaves_rest(at_ + step.change)) {
            step_ = 0.2 * size;
        } else if (size > kShortest && step.error > precision_.tolerance) {
            step_ = next;
        } else {
            step_ = h < step_ ? std::max(next, step_) : next;
            const bool slipped = slips();
            advance(step.change);
            rate_ = slipped && slips() ? step.rate : rates(at_);
        }
    }

    [[nodiscard]] bool slips() const { return !nose_.at_rest() && !cloth_.at_rest(); }

    [[nodiscard]] Step dormand_prince(Real h) const;

    void advance(const Progress& change) {
        at_ = at_ + change;
        settle();
    }

    /// Decides which contacts slip from here on.
    void settle() {
        nose_.remember_direction(nose_slip(at_));
        cloth_.remember_direction(cloth_slip(at_));
        settle_nose();
        settle_cloth();
    }

    void settle_nose() {
        if (nose_.at_rest()) {
            nose_.set_at_rest(nose_.slower_than(leaving(), nose_slip(at_)));
        } else if (!cloth_.at_rest() && nose_.slower_than(precision_.rest_slip, nose_slip(at_))) {
            const Vec2 cloth = cloth_.last_direction();
            const bool holds = friction_.nose_holds(cloth);
            if (holds)
                at_.friction =
                    at_.friction + friction_.stop_nose(nose_.slow_slip(nose_slip(at_)), cloth);
            nose_.set_at_rest(
                holds || nose_.sets_out_in(friction_.nose_at_rest(cloth).nose, nose_slip(at_)));
        }
    }

    void settle_cloth() {
        if (cloth_.at_rest()) {
            cloth_.set_at_rest(cloth_.slower_than(leaving(), cloth_slip(at_)));
        } else if (!nose_.at_rest() && cloth_.slower_than(precision_.rest_slip, cloth_slip(at_))) {
            const Vec2 nose = nose_.last_direction();
            const bool holds = friction_.cloth_holds(nose);
            if (holds)
                at_.friction =
                    at_.friction + RailFriction::stop_cloth(cloth_.slow_slip(cloth_slip(at_)));
            cloth_.set_at_rest(
                holds || cloth_.sets_out_in(friction_.cloth_at_rest(nose).cloth, cloth_slip(at_)));
        }
    }

    [[nodiscard]] bool leaves_rest(const Progress& at) const {
        return (nose_.at_rest() && !nose_.slower_than(2 * leaving(), nose_slip(at))) ||
               (cloth_.at_rest() && !cloth_.slower_than(2 * leaving(), cloth_slip(at)));
    }

    [[nodiscard]] Real leaving() const { return std::max(Real{1e-3}, 10 * precision_.rest_slip); }

    ImpactPrecision precision_;
    Real cos_theta_;
    RailFriction friction_;
    SlidingContact nose_;
    SlidingContact cloth_;
    Real work_at_end_ = 0;
    Real step_ = 1;
    Progress at_;
    Progress rate_;  // of change of at_
};

consteval Real ratio(int p, int q) {
    return static_cast<Real>(p) / q;
}

/// Dormand, Prince 1980, "A family of embedded Runge-Kutta formulae", RK5(4)7M.
Impact::Step Impact::dormand_prince(Real h) const {
    const Progress& k1 = rate_;
    const auto after = [&](const Progress& change) { return rates(at_ + h * change); };
    const Progress k2 = after(ratio(1, 5) * k1);
    const Progress k3 = after(ratio(3, 40) * k1 + ratio(9, 40) * k2);
    const Progress k4 = after(ratio(44, 45) * k1 + ratio(-56, 15) * k2 + ratio(32, 9) * k3);
    const Progress k5 = after(ratio(19372, 6561) * k1 + ratio(-25360, 2187) * k2 +
                              ratio(64448, 6561) * k3 + ratio(-212, 729) * k4);
    const Progress k6 =
        after(ratio(9017, 3168) * k1 + ratio(-355, 33) * k2 + ratio(46732, 5247) * k3 +
              ratio(49, 176) * k4 + ratio(-5103, 18656) * k5);
    const Progress mean = ratio(35, 384) * k1 + ratio(500, 1113) * k3 + ratio(125, 192) * k4 +
                          ratio(-2187, 6784) * k5 + ratio(11, 84) * k6;
    const Progress k7 = after(mean);
    const Progress error = ratio(71, 57600) * k1 + ratio(-71, 16695) * k3 + ratio(71, 1920) * k4 +
                           ratio(-17253, 339200) * k5 + ratio(22, 525) * k6 + ratio(-1, 40) * k7;
    return {h * mean, k7, abs(h) * largest(error)};
}

}  // namespace

void bounce_mathavan2010(const RailContact& rail, const ImpactPrecision& precision, Vec3& v,
                         Vec3& w) {
    const BallAtRail ball(rail, v, w);
    if (!(ball.v.y > 0)) return;
    const RailImpulse unit = Impact(rail, ball, precision).run(rail.e);
    apply({ball.v.y * unit.normal, ball.v.y * unit.nose, ball.v.y * unit.cloth}, ball, rail, v, w);
}

void bounce_mathavan2010(const RailContact& rail, Vec3& v, Vec3& w) {
    bounce_mathavan2010(rail, kExactImpact, v, w);
}

void bounce_mathavan2010_fast(const RailContact& rail, Vec3& v, Vec3& w) {
    bounce_mathavan2010(rail, kFastImpact, v, w);
}

}  // namespace poolhall
