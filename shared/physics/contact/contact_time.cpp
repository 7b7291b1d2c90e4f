#include "shared/physics/contact/contact_time.hpp"

#include "shared/math/double_double.hpp"
#include "shared/physics/contact/time_of_impact.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace poolhall {

namespace {

constexpr int kMaxIterations = 100 * kRealDigits / 53;
/// A bound of the relative rounding error of a place, generously.
constexpr Real kRounding = 4 * kEpsilon;
/// Relative error that plain numbers may leave in a time.
constexpr Real kAllowed = 16 * kEpsilon;
/// Relative error allowed in the instant of an extreme: that of the extreme is its square.
constexpr Real kExtremeTolerance = kRootEpsilon / 4;

/// c + v t + a t^2 / 2 of one coordinate.
DoubleDouble precise_place(Real c, Real v, Real a, Real t) {
    const DoubleDouble speed = DoubleDouble{v} + two_product(a, t / 2);
    return DoubleDouble{c} + speed * DoubleDouble{t};
}

DoubleDouble precise_square(const RelativeArc<Vec2>& arc, Real t) {
    const DoubleDouble x = precise_place(arc.c.x, arc.v.x, arc.a.x, t);
    const DoubleDouble y = precise_place(arc.c.y, arc.v.y, arc.a.y, t);
    return x * x + y * y;
}

DoubleDouble precise_square(const RelativeArc<Vec3>& arc, Real t) {
    const DoubleDouble z = precise_place(arc.c.z, arc.v.z, arc.a.z, t);
    return precise_square({xy(arc.c), xy(arc.v), xy(arc.a)}, t) + z * z;
}

/// The gap |c(t)|^2 - d^2 as a function of time.
template <class Vec>
class Gap {
  public:
    Gap(const RelativeArc<Vec>& arc, Real distance)
        : arc_(arc),
          distance_(distance),
          k0_(dot(arc.c, arc.c) - distance * distance),
          k1_(2 * dot(arc.c, arc.v)),
          k2_(dot(arc.v, arc.v) + dot(arc.a, arc.c)),
          k3_(dot(arc.a, arc.v)),
          k4_(dot(arc.a, arc.a) / 4) {}

    /// From the place itself: the expanded polynomial would cancel.
    [[nodiscard]] Real at(Real t) const {
        const Vec c = place(t);
        return dot(c, c) - distance_ * distance_;
    }

    [[nodiscard]] Real rate(Real t) const { return 2 * dot(place(t), arc_.v + t * arc_.a); }

    [[nodiscard]] Real precise_at(Real t) const {
        return value(precise_square(arc_, t) - two_product(distance_, distance_));
    }

    /// How far rounding may move at(t), near contact.
    [[nodiscard]] Real uncertainty(Real t) const {
        const Real reach = sqrt(dot(arc_.c, arc_.c)) +
                           t * (sqrt(dot(arc_.v, arc_.v)) + t * sqrt(dot(arc_.a, arc_.a)));
        return kRounding * reach * (2 * distance_);
    }

    [[nodiscard]] Real slope(Real t) const {
        return ((4 * k4_ * t + 3 * k3_) * t + 2 * k2_) * t + k1_;
    }

    [[nodiscard]] Real curvature(Real t) const { return (12 * k4_ * t + 6 * k3_) * t + 2 * k2_; }

    /// The least curvature up to the horizon.
    [[nodiscard]] Real least_curvature(Real horizon) const {
        if (k3_ >= 0) return 2 * k2_;
        if (-k3_ > 4 * k4_ * horizon) return curvature(horizon);
        return 2 * k2_ - 3 * k3_ * k3_ / (4 * k4_);
    }

    /// The first root of the parabola that it begins as; infinity if that has none.
    [[nodiscard]] Real parabola_root() const {
        const Real discriminant = k1_ * k1_ - 4 * k0_ * k2_;
        return discriminant > 0 ? 2 * k0_ / (sqrt(discriminant) - k1_) : kInfinity;
    }

    /// True for balls that all but touch from the beginning: then the expanded polynomial is the
    /// more exact one, if its first term is.
    [[nodiscard]] bool begins_near() const { return k0_ < distance_ * distance_ / 8; }

    void sharpen_begin() { k0_ = precise_at(0); }

    [[nodiscard]] Real expanded_at(Real t) const {
        return k0_ + t * (k1_ + t * (k2_ + t * (k3_ + t * k4_)));
    }

    /// How far rounding moves expanded_at(t) and at(t), near contact: what the terms have, by two
    /// roundings each, and twice the distance times what the place has, by three.
    [[nodiscard]] Real expanded_rounding(Real t) const {
        const Real way = t * (sum_of_sides(arc_.v) + t * sum_of_sides(arc_.a));
        return kEpsilon * (k0_ + 2 * way * (sum_of_sides(arc_.c) + way));
    }

    [[nodiscard]] Real rounding(Real t) const {
        const Real way = t * (sum_of_sides(arc_.v) + (t / 2) * sum_of_sides(arc_.a));
        return 1.5 * kEpsilon * distance_ * (2 * way + distance_);
    }

    /// A gap that rounding cannot close, nor open a depth of it.
    [[nodiscard]] Real graze() const { return 0x1p-20 * distance_ * distance_; }

    /// Whether, with that square of its slope, it falls at t as no graze does.
    [[nodiscard]] bool meets_steeply(Real t, Real square) const {
        constexpr Real kGraze = 0x1p-10;  // square of the cosine at the impact
        const Vec v = arc_.v + t * arc_.a;
        return square > kGraze * (4 * distance_ * distance_ * dot(v, v));
    }

    [[nodiscard]] Real third_derivative(Real t) const { return 24 * k4_ * t + 6 * k3_; }

    [[nodiscard]] Real k0() const { return k0_; }

    [[nodiscard]] Real k1() const { return k1_; }

    /// Writes the roots of curvature() in (0, horizon), rising; says how many.
    std::size_t inflections(Real horizon, std::array<Real, 2>& roots) const {
        const Real discriminant = 9 * k3_ * k3_ - 24 * k4_ * k2_;
        if (!(discriminant > 0)) return 0;
        const Real q = -(3 * k3_ + (k3_ >= 0 ? 1 : -1) * sqrt(discriminant));
        Real first = k4_ > 0 ? q / (12 * k4_) : -1;
        Real second = q != 0 ? 2 * k2_ / q : -1;
        if (first > second) std::swap(first, second);
        std::size_t count = 0;
        for (const Real root : {first, second}) {
            if (root > 0 && root < horizon) roots[count++] = root;
        }
        return count;
    }

  private:
    static Real sum_of_sides(Vec2 a) { return abs(a.x) + abs(a.y); }

    static Real sum_of_sides(const Vec3& a) { return abs(a.x) + abs(a.y) + abs(a.z); }

    [[nodiscard]] Vec place(Real t) const { return arc_.c + t * (arc_.v + (t / 2) * arc_.a); }

    RelativeArc<Vec> arc_;
    Real distance_;
    Real k0_, k1_, k2_, k3_, k4_;
};

/// A stretch on which a function changes sign and is monotonic, with its values at both ends.
struct Bracket {
    Real low;
    Real high;
    Real at_low;
    Real at_high;
};

/// The root of f in the bracket; `rate` is its derivative. Newton's iteration from the secant's
/// root, halving where it would leave the bracket, until settled(step, rate, t).
template <class F, class Rate, class Settled>
Real polish(F f, Rate rate, Bracket bracket, Settled settled) {
    auto [low, high, at_low, at_high] = bracket;
    Real t = low + (high - low) * (at_low / (at_low - at_high));
    for (int i = 0; i < kMaxIterations; ++i) {
        const Real y = f(t);
        if (y == 0) return t;
        if ((y > 0) == (at_low > 0)) {
            low = t;
        } else {
            high = t;
        }
        const Real slope = rate(t);
        Real next = t - y / slope;
        if (!(next > low && next < high)) next = (low + high) / 2;
        if (next == t || settled(next - t, slope, t)) return next;
        t = next;
    }
    return t;
}

/// Improves a root at which the gap is so flat that its rounding shows.
template <class Vec>
Real refine(const Gap<Vec>& gap, Real t, Real horizon) {
    const Real rate = gap.rate(t);
    if (gap.uncertainty(t) <= kAllowed * t * abs(rate)) return t;
    for (int i = 0; i < kMaxIterations; ++i) {
        const Real next = t - gap.precise_at(t) / gap.rate(t);
        if (!(next >= 0 && next <= horizon)) break;
        const bool done = abs(next - t) <= kExtremeTolerance * t;
        t = next;
        if (done) break;
    }
    return t;
}

struct RootStep {
    Real size;
    Real error;  ///< what it leaves of the way to the root; infinite where it is long
};

/// Towards the earlier root of a function that curves upwards, from its value and derivatives: near
/// the root Chebyshev's step, whose error is of third order; further away to the root of the
/// parabola there, or where that has none, to its least place.
RootStep step_to_root(Real y, Real slope, Real curvature, Real third) {
    constexpr Real kNear = 0x1p-5;
    const Real square = slope * slope;
    const Real bend = y * curvature;
    if (slope < 0 && abs(bend) < kNear * square) {
        const Real inverse = 1 / slope;
        const Real newton = -y * inverse;
        const Real bent = curvature * newton * inverse / 2;
        return {newton * (1 - bent),
                abs(newton) * (2 * bent * bent + newton * newton * abs(third * inverse) / 6)};
    }
    if (!(square > 2 * bend)) return {-slope / curvature, kInfinity};
    const Real root = sqrt(square - 2 * bend);
    return {slope < 0 ? 2 * y / (root - slope) : -(slope + root) / curvature, kInfinity};
}

/// The contact of an ordinary approach, or kNever: where the gap falls at the beginning, curves
/// upwards all the while, and is no graze. Nothing where that is not so, or rounding could decide.
template <class Vec>
std::optional<Real> plain_contact(Gap<Vec>& gap, Real horizon) {
    constexpr int kEnough = 6 + kRealDigits / 53;
    const Real least_curvature = gap.least_curvature(horizon);
    if (!(gap.k0() > 0 && gap.k1() < 0 && least_curvature > 0)) return std::nullopt;
    const bool near = gap.begins_near();
    if (near) gap.sharpen_begin();
    Real t = std::min(gap.parabola_root(), horizon);
    for (int i = 0; i < kEnough; ++i) {
        const Real y = near ? gap.expanded_at(t) : gap.at(t);
        const Real slope = near ? gap.slope(t) : gap.rate(t);
        const Real square = slope * slope;
        const Real sure = y - gap.graze();
        // It lies above a parabola of its least curvature through this point.
        if (sure > 0 && (2 * least_curvature * sure > square || (t == horizon && slope < 0)))
            return kNever;
        const RootStep step = step_to_root(y, slope, gap.curvature(t), gap.third_derivative(t));
        if (step.error <= kAllowed / 16 * t) {
            const Real rounding = near ? gap.expanded_rounding(t) : gap.rounding(t);
            const bool is_sure = rounding <= kAllowed * t * -slope && gap.meets_steeply(t, square);
            if (!is_sure) return std::nullopt;
            return t + step.size <= horizon ? t + step.size : kNever;
        }
        t = std::clamp(t + step.size, Real{0}, horizon);
    }
    return std::nullopt;
}

/// Searches one stretch after another on which the gap falls or rises without turning.
template <class Vec>
Real first_contact_curved(const RelativeArc<Vec>& arc, Real distance, Real horizon) {
    Gap<Vec> gap(arc, distance);
    if (gap.k0() <= 0 && (gap.k1() < 0 || (gap.k1() == 0 && gap.curvature(0) < 0))) return 0;
    if (const auto root = plain_contact(gap, horizon)) return *root;
    std::array<Real, 2> inflections{};
    const std::size_t inflection_count = gap.inflections(horizon, inflections);
    const auto root_in = [&](const Bracket& bracket) {
        const Real t =
            polish([&](Real x) { return gap.at(x); }, [&](Real x) { return gap.rate(x); }, bracket,
                   [&](Real step, Real rate, Real x) {
                       // What Newton's step leaves: step^2 f'' / (2 f').
                       return step * step * abs(gap.curvature(x)) <= kAllowed / 8 * x * abs(rate);
                   });
        return refine(gap, t, horizon);
    };

    Real low = 0;
    Real gap_low = gap.k0();
    Real slope_begin = gap.k1();
    Real begin = 0;
    for (std::size_t i = 0; i <= inflection_count; ++i) {
        const Real end = i < inflection_count ? inflections[i] : horizon;
        const Real slope_end = gap.slope(end);
        // On [begin, end] the slope is monotonic: at most one extreme.
        const bool turns = (slope_begin < 0) != (slope_end < 0);
        const Real high =
            turns
                ? polish([&](Real x) { return gap.slope(x); },
                         [&](Real x) { return gap.curvature(x); },
                         {begin, end, slope_begin, slope_end},
                         [](Real step, Real, Real x) { return abs(step) <= kExtremeTolerance * x; })
                : end;
        Real gap_high = gap.at(high);
        if (turns && slope_begin < 0 && abs(gap_high) <= gap.uncertainty(high))
            gap_high = gap.precise_at(high);
        // Touching to within rounding, they opened too little to show and close again.
        if (turns && slope_begin >= 0 && gap_high <= gap.uncertainty(high)) return high;
        if (gap_low > 0 && gap_high <= 0 && slope_begin < 0)
            return root_in({low, high, gap_low, gap_high});
        low = high;
        gap_low = gap_high;
        if (turns && slope_end < 0) {
            const Real gap_end = gap.at(end);
            if (gap_low > 0 && gap_end <= 0) return root_in({low, end, gap_low, gap_end});
            low = end;
            gap_low = gap_end;
        }
        begin = end;
        slope_begin = slope_end;
    }
    return kNever;
}

/// What a bound must be exceeded by, relatively: far more than rounding.
constexpr Real kMargin = 1 + 0x1p-30;

/// True if the two cannot meet by their distance along c alone.
bool stay_apart_along(Real c_c, Real c_v, Real c_a, Real distance, Real horizon) {
    // c(t) . c / |c| is a lower bound of |c(t)|.
    Real least = std::min(c_c, c_c + horizon * (c_v + horizon * c_a / 2));
    if (c_a > 0 && c_v < 0 && -c_v < c_a * horizon) least = c_c - c_v * c_v / (2 * c_a);
    return least > 0 && least * least > kMargin * c_c * distance * distance;
}

}  // namespace

bool stay_apart(Vec2 c, Vec2 v, Vec2 a, Real distance, Real horizon) {
    const Real c_v = dot(c, v);
    const Real c_a = dot(c, a);
    const Real v_v = dot(v, v);
    if (c_v > 0) {
        // The derivative of |c(t)|^2 / 2 is c.v + (v.v + a.c) t + 3/2 a.v t^2 + 1/2 a.a t^3.
        const Real linear = v_v + c_a;
        const Real square = 1.5 * horizon * std::min(dot(a, v), Real{0});
        const Real rounding = 0x1p-30 * horizon * (abs(linear) - square);
        if (c_v + horizon * std::min(linear + square, Real{0}) > rounding) return true;
    }
    if (stay_apart_along(dot(c, c), c_v, c_a, distance, horizon)) return true;
    // By their distance aside from v.
    const Real aside = cross(c, v);
    const Real aside_later = aside + cross(a, v) * (horizon * horizon / 2);
    const Real reach = kMargin * distance * distance * v_v;
    return aside * aside_later > 0 && aside * aside > reach && aside_later * aside_later > reach;
}

Real first_contact_straight(Vec2 c, Vec2 v, Real deceleration, Real distance, Real horizon) {
    // The way s(t) = |v| t - a t^2/2 is |v| tau, where tau is the time it would take without
    // deceleration.
    const auto tau = time_of_impact({{}, {}}, {c, v}, distance);
    if (!tau) return kNever;
    const Real lost = 1 - 2 * deceleration * *tau / norm(v);
    if (lost < 0) return kNever;
    const Real t = 2 * *tau / (1 + sqrt(lost));
    return t <= horizon ? t : kNever;
}

Real first_contact(const RelativeArc<Vec2>& arc, Real distance, Real horizon) {
    if (arc.a == Vec2{}) return first_contact_straight(arc.c, arc.v, 0, distance, horizon);
    // On a straight line, what approaches meets on its way there or never.
    if (cross(arc.v, arc.a) == 0 && dot(arc.c, arc.v) < 0) {
        const Real deceleration = dot(arc.v, arc.a) < 0 ? norm(arc.a) : -norm(arc.a);
        return first_contact_straight(arc.c, arc.v, deceleration, distance, horizon);
    }
    return first_contact_curved(arc, distance, horizon);
}

Real first_contact(const RelativeArc<Vec3>& arc, Real distance, Real horizon) {
    if (arc.a == Vec3{}) {
        const Real t = straight_contact(arc.c, arc.v, distance);
        return t <= horizon ? t : kNever;
    }
    if (stay_apart_along(dot(arc.c, arc.c), dot(arc.c, arc.v), dot(arc.c, arc.a), distance,
                         horizon))
        return kNever;
    return first_contact_curved(arc, distance, horizon);
}

Real straight_contact(const Vec3& c, const Vec3& v, Real distance) {
    const Real approach = -dot(c, v);
    if (approach <= 0) return kNever;
    const Real gap = dot(c, c) - distance * distance;
    if (gap <= 0) return 0;
    // The cross product's form does not cancel near grazing.
    const Vec3 area = cross(c, v);
    const Real q = dot(v, v) * distance * distance - dot(area, area);
    return q < 0 ? kNever : gap / (approach + sqrt(q));
}

Real time_to_close(Real gap, Real v, Real a) {
    if (gap <= 0) {
        if (v > 0 || (v == 0 && a > 0)) return 0;
        return v < 0 && a > 0 ? -2 * v / a : kNever;
    }
    Real discriminant = v * v + 2 * a * gap;
    if (abs(discriminant) <= kRounding * v * v)
        discriminant = value(two_product(v, v) + two_product(2 * a, gap));
    if (discriminant < 0) return kNever;
    const Real root = sqrt(discriminant);
    if (v > 0) return 2 * gap / (v + root);
    return a > 0 ? (root - v) / a : kNever;
}

}  // namespace poolhall
