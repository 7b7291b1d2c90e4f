#include "shared/physics/contact/mathavan_rail.hpp"

#include "shared/physics/contact/rail_frame.hpp"
#include "shared/physics/contact/rail_friction.hpp"
#include "shared/physics/contact/sliding_contact.hpp"

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

/// What the rates depend on: the slips, each in the scale of its contact, and how the approach
/// changes. Linear in Progress; also its derivative.
struct Slips {
    Vec2 nose;
    Vec2 cloth;
    Real approach = 0;
};

Slips operator+(const Slips& a, const Slips& b) {
    return {a.nose + b.nose, a.cloth + b.cloth, a.approach + b.approach};
}

Slips operator*(Real s, const Slips& a) {
    return {s * a.nose, s * a.cloth, s * a.approach};
}

/// How a slip changes with the normal impulse and with either friction, component by component.
struct SlipRates {
    Vec2 drive;
    Vec2 by_nose;
    Vec2 by_cloth;

    [[nodiscard]] Vec2 at(const Forces& f) const {
        return {drive.x + by_nose.x * f.nose.x + by_cloth.x * f.cloth.x,
                drive.y + by_nose.y * f.nose.y + by_cloth.y * f.cloth.y};
    }
};

/// The rates at one stage of a step.
struct Stage {
    Slips slips;      ///< their rates
    Forces friction;  ///< rates of the impulses
    Real approach;    ///< how it has changed: the rate of the work
};

/// An impact as an initial value problem in the nose's normal impulse.
class Impact {
  public:
    Impact(const RailContact& rail, const BallAtRail& ball, const ImpactPrecision& precision)
        : precision_(precision),
          cos_theta_(ball.cos_theta),
          friction_(ball.sin_theta, ball.cos_theta, rail.mu, rail.mu_table),
          nose_(ball.nose_slip(), ball.v.y, rail.mu),
          cloth_(ball.cloth_slip(), ball.v.y, rail.mu_table),
          nose_rates_(rates_of(
              nose_, [this](Real n, const Forces& f) { return friction_.nose_slip(n, f); })),
          cloth_rates_(rates_of(
              cloth_, [this](Real n, const Forces& f) { return friction_.cloth_slip(n, f); })) {}

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
        return {1, forces(slips_at(at)), cos_theta_ * approach(at)};
    }

    [[nodiscard]] Slips slips_at(const Progress& at) const {
        return {nose_.slip(nose_slip(at)), cloth_.slip(cloth_slip(at)), approach(at)};
    }

    [[nodiscard]] Forces forces(const Slips& at) const {
        if (nose_.at_rest()) return friction_.nose_at_rest(cloth_.direction_of(at.cloth));
        const Vec2 nose = nose_.direction_of(at.nose);
        if (cloth_.at_rest()) return friction_.cloth_at_rest(nose);
        return friction_.slipping(nose, cloth_.direction_of(at.cloth));
    }

    [[nodiscard]] Stage stage_of(const Forces& f, Real approach) const {
        return {{nose_rates_.at(f), cloth_rates_.at(f), friction_.approach(1, f)}, f, approach};
    }

    /// Of the contact whose slip changes like that, in its scale.
    template <class Change>
    static SlipRates rates_of(const SlidingContact& contact, Change change) {
        const Vec2 drive = change(1, Forces{});
        const Vec2 by_nose = change(0, Forces{{1, 1}, {}});
        const Vec2 by_cloth = change(0, Forces{{}, {1, 1}});
        return {contact.unit() * drive, contact.unit() * by_nose, contact.unit() * by_cloth};
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
        // The rest of so short a way is straight: what bends is its square.
        const Real close = std::min(sqrt(precision_.tolerance) / 10, Real{1e-5});
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

    /// What steps are measured by, as they have to become ever shorter towards the end of a slip.
    [[nodiscard]] Real pace() const {
        return std::min({nose_.pace(nose_slip(at_), nose_slip(rate_)),
                         cloth_.pace(cloth_slip(at_), cloth_slip(rate_)), Real{1}});
    }

    /// A step of at most that impulse, or nothing but a shorter step for the next time.
    void try_step(Real limit) {
        constexpr Real kShortest = 1e-12;
        const Real pace = this->pace();
        const Real h = std::min({limit, step_ * pace, precision_.longest_step});
        const Step step = dormand_prince(h);
        const Real size = abs(h);
        const Real fit = sqrt(sqrt(precision_.tolerance / std::max(step.error, Real{1e-30})));
        const Real next = size / pace * std::clamp(0.85 * fit, Real{0.1}, Real{5});
        if (size > kShortest && leaves_rest(at_ + step.change)) {
            step_ = 0.2 * size / pace;
        } else if (size > kShortest && step.error > precision_.tolerance) {
            step_ = next;
        } else {
            step_ = h < step_ * pace ? std::max(next, step_) : next;
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
            nose_.set_at_rest(holds);
            if (!holds) set_out(nose_, friction_.nose_at_rest(cloth).nose, nose_slip(at_));
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
            cloth_.set_at_rest(holds);
            if (!holds) set_out(cloth_, friction_.cloth_at_rest(nose).cloth, cloth_slip(at_));
        }
    }

    /// A contact that friction cannot keep at rest begins to slip along what friction there is.
    void set_out(SlidingContact& contact, Vec2 force, Vec2 slip) const {
        if (contact.sets_out_in(force, slip)) contact.set_out_along(force, precision_.rest_slip);
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
    SlipRates nose_rates_;
    SlipRates cloth_rates_;
    Real work_at_end_ = 0;
    Real step_ = 0.25;  ///< the next one, over the pace
    Progress at_;
    Progress rate_;  // of change of at_
};

consteval Real ratio(int p, int q) {
    return static_cast<Real>(p) / q;
}

/// Dormand, Prince 1980, "A family of embedded Runge-Kutta formulae", RK5(4)7M.
Impact::Step Impact::dormand_prince(Real h) const {
    const Slips begin = slips_at(at_);
    const auto after = [&](const Slips& change) {
        const Slips at = begin + change;
        return stage_of(forces(at), at.approach);
    };
    // With the step in the weights, the last rate is soon in the next stage.
    const auto w = [h](Real weight) { return h * weight; };
    const Stage k1 = stage_of(rate_.friction, begin.approach);
    const Stage k2 = after(w(ratio(1, 5)) * k1.slips);
    const Stage k3 = after(w(ratio(3, 40)) * k1.slips + w(ratio(9, 40)) * k2.slips);
    const Stage k4 = after(w(ratio(44, 45)) * k1.slips + w(ratio(-56, 15)) * k2.slips +
                           w(ratio(32, 9)) * k3.slips);
    const Stage k5 = after(w(ratio(19372, 6561)) * k1.slips + w(ratio(-25360, 2187)) * k2.slips +
                           w(ratio(64448, 6561)) * k3.slips + w(ratio(-212, 729)) * k4.slips);
    const Stage k6 = after(w(ratio(9017, 3168)) * k1.slips + w(ratio(-355, 33)) * k2.slips +
                           w(ratio(46732, 5247)) * k3.slips + w(ratio(49, 176)) * k4.slips +
                           w(ratio(-5103, 18656)) * k5.slips);
    const Stage k7 = after(w(ratio(35, 384)) * k1.slips + w(ratio(500, 1113)) * k3.slips +
                           w(ratio(125, 192)) * k4.slips + w(ratio(-2187, 6784)) * k5.slips +
                           w(ratio(11, 84)) * k6.slips);
    const auto sum = [&](auto weigh) {
        return Progress{weigh([](const Stage&) { return Real{1}; }),
                        {weigh([](const Stage& k) { return k.friction.nose; }),
                         weigh([](const Stage& k) { return k.friction.cloth; })},
                        cos_theta_ * weigh([](const Stage& k) { return k.approach; })};
    };
    Progress mean = sum([&](auto of) {
        return ratio(35, 384) * of(k1) + ratio(500, 1113) * of(k3) + ratio(125, 192) * of(k4) +
               ratio(-2187, 6784) * of(k5) + ratio(11, 84) * of(k6);
    });
    mean.normal = 1;
    const Progress error = sum([&](auto of) {
        return ratio(71, 57600) * of(k1) + ratio(-71, 16695) * of(k3) + ratio(71, 1920) * of(k4) +
               ratio(-17253, 339200) * of(k5) + ratio(22, 525) * of(k6) + ratio(-1, 40) * of(k7);
    });
    return {h * mean, {1, k7.friction, cos_theta_ * k7.approach}, abs(h) * largest(error)};
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
