#include "shared/physics/contact/contact.hpp"

#include "shared/physics/contact/ball_ball.hpp"
#include "shared/physics/contact/han_rail.hpp"
#include "shared/physics/contact/mathavan_balls.hpp"
#include "shared/physics/contact/mathavan_rail.hpp"

#include <algorithm>

namespace poolhall {

namespace {

/// A group settles in a few rounds; elastic ones at most in as many as there are orders of impacts.
constexpr int kMaxRounds = 1000;
/// Speeds within this share of the balls' are rounding.
constexpr Real kStill = 1e-12 * kFineness;
/// Share of the group's speed that double-double arithmetic leaves of zero, generously.
constexpr Real kRounding = 0x1p14 * kEpsilon * kEpsilon;
/// Contacts that a group can have without a larger memory: a rack of fifteen has thirty.
constexpr std::size_t kGroupCapacity = 40;

/// Whether the contact moves ball `ball` along its normal (+1), against it (-1) or not at all.
Real direction_on(const Contact& contact, std::size_t ball) {
    if (contact.a == ball) return -1;
    return contact.kind == Contact::Kind::kBalls && contact.b == ball ? 1 : 0;
}

Vec3 velocity(const MovingBall& ball) {
    return {ball.v.x, ball.v.y, ball.climb};
}

void set_velocity(MovingBall& ball, const Vec3& v) {
    ball.v = xy(v);
    ball.climb = v.z;
}

/// Rate at which the gap of the contact opens, m/s.
Real opening(const Contact& contact, const Vec3& n, std::span<const MovingBall> balls) {
    const Real a = dot(velocity(balls[contact.a]), n);
    return contact.kind == Contact::Kind::kRail ? -a : dot(velocity(balls[contact.b]), n) - a;
}

bool share_a_ball(const Contact& c, const Contact& d) {
    return direction_on(d, c.a) != 0 ||
           (c.kind == Contact::Kind::kBalls && direction_on(d, c.b) != 0);
}

/// The number nearest to v + change; nothing where all but rounding of the double-doubles cancels.
Real changed(Real v, DoubleDouble change, Real rounding) {
    const Real sum = value(DoubleDouble{v} + change);
    return abs(sum) <= rounding ? 0 : sum;
}

/// Who takes the vertical part of friction between two balls.
VerticalPart vertical_part(const MovingBall& a, const MovingBall& b) {
    return a.motion == Motion::kAirborne || b.motion == Motion::kAirborne ? VerticalPart::kToBalls
                                                                          : VerticalPart::kToSlate;
}

void add(Vec3DoubleDouble& sum, DoubleDouble factor, const Vec3& v) {
    sum.x = sum.x + factor * DoubleDouble{v.x};
    sum.y = sum.y + factor * DoubleDouble{v.y};
    sum.z = sum.z + factor * DoubleDouble{v.z};
}

}  // namespace

Contact rail_contact(std::size_t ball, Rail rail) {
    return {Contact::Kind::kRail, ball, ball, rail, outward_normal(rail)};
}

Contact ball_contact(std::size_t a, std::size_t b) {
    return {Contact::Kind::kBalls, a, b, Rail::kNorth, {}};
}

Vec2 outward_normal(Rail rail) {
    switch (rail) {
        case Rail::kNorth:
            return {0, 1};
        case Rail::kEast:
            return {1, 0};
        case Rail::kSouth:
            return {0, -1};
        case Rail::kWest:
            return {-1, 0};
        default:  // jaws have no one normal
            return {};
    }
}

bool stands_alone(const Contact& contact, std::span<const Contact> contacts) {
    return std::none_of(contacts.begin(), contacts.end(), [&](const Contact& other) {
        const bool between_balls =
            contact.kind == Contact::Kind::kBalls || other.kind == Contact::Kind::kBalls;
        return &contact != &other && between_balls && share_a_ball(contact, other);
    });
}

ContactSolver::ContactSolver() : problem_(kGroupCapacity) {
    group_.reserve(kGroupCapacity);
    approaching_.reserve(kGroupCapacity);
    normals_.reserve(kGroupCapacity);
    pushes_.reserve(kGroupCapacity);
    least_openings_.reserve(kGroupCapacity);
}

void ContactSolver::prepare(const ImpactModels& models) {
    rail_ = models.rail;
    e_ball_ = restitution_of(models.ball_ball);
    e_rail_ = rail_.model == RailModel::kElastic ? 1 : rail_.e;
    mu_table_ = models.mu_table;
    unit_mass_ = models.unit_mass;
    min_separation_ = models.pressed ? models.ball_ball.min_separation : 0;
    in_space_ = models.in_space;
    has_friction_ = has_friction(models.ball_ball);
    cloth_rubs_ = has_friction_ && models.ball_ball.model == BallBallModel::kMathavan2014;
    friction_ = BallFriction(models.ball_ball);
    changes_.assign(models.balls, {});
    slow_impacts_.assign(models.balls * models.balls, {});
    slow_bounces_.assign(models.balls, {});
}

Vec3 ContactSolver::normal_of(const Contact& contact, std::span<const MovingBall> balls) const {
    if (contact.kind == Contact::Kind::kRail) return {contact.normal.x, contact.normal.y, 0};
    const MovingBall& a = balls[contact.a];
    const MovingBall& b = balls[contact.b];
    const Real rise = in_space_ ? (b.radius + b.height) - (a.radius + a.height) : 0;
    const Vec2 c = b.r - a.r;
    if (rise != 0) return normalized(Vec3{c.x, c.y, rise});
    const Vec2 n = normalized(c);
    return {n.x, n.y, 0};
}

bool ContactSolver::is_group_member(const Contact& contact) const {
    return contact.kind == Contact::Kind::kBalls || !has_nose(rail_.model);
}

Real ContactSolver::restitution(const Contact& contact) const {
    return contact.kind == Contact::Kind::kRail ? e_rail_ : e_ball_;
}

bool ContactSolver::resolve(std::span<const Contact> contacts, std::span<MovingBall> balls) {
    for (const Contact& contact : contacts) {
        if (!is_group_member(contact)) bounce(contact, balls[contact.a]);
    }
    group_.clear();
    for (const Contact& contact : contacts) {
        if (!is_group_member(contact)) continue;
        if (!stands_alone(contact, contacts)) {
            group_.push_back(contact);
        } else if (contact.kind == Contact::Kind::kRail) {
            bounce(contact, balls[contact.a]);
        } else {
            collide(contact, balls);
        }
    }
    return group_.empty() || resolve_group(balls);
}

void ContactSolver::bounce(const Contact& contact, MovingBall& ball) {
    reflect(contact, ball);
    if (min_separation_ == 0) return;
    const Real leaves = -dot(ball.v, contact.normal);
    const Real least = slow_bounces_[contact.a].least_speed(leaves, min_separation_);
    if (leaves < least) ball.v = ball.v - (least - leaves) * contact.normal;
}

void ContactSolver::reflect(const Contact& contact, MovingBall& ball) const {
    if (!has_nose(rail_.model)) {
        // Along an axis the other component must keep its bits.
        if (contact.normal.y == 0) {
            ball.v.x = -e_rail_ * ball.v.x;
        } else if (contact.normal.x == 0) {
            ball.v.y = -e_rail_ * ball.v.y;
        } else {
            ball.v = ball.v - ((1 + e_rail_) * dot(ball.v, contact.normal)) * contact.normal;
        }
        return;
    }
    const Real e = restitution_of(rail_, dot(ball.v, contact.normal));
    const RailContact rail{contact.normal, ball.radius, ball.mass, rail_.nose_height, e,
                           rail_.mu,       mu_table_};
    Vec3 v = velocity(ball);
    switch (rail_.model) {
        case RailModel::kHan2005:
            bounce_han2005(rail, v, ball.w);
            break;
        case RailModel::kMathavan2010Fast:
            bounce_mathavan2010_fast(rail, v, ball.w);
            break;
        default:
            bounce_mathavan2010(rail, v, ball.w);
            break;
    }
    set_velocity(ball, v);
}

void ContactSolver::collide(const Contact& contact, std::span<MovingBall> balls) {
    MovingBall& a = balls[contact.a];
    MovingBall& b = balls[contact.b];
    const Vec3 n = normal_of(contact, balls);
    const Real approach = dot(velocity(a) - velocity(b), n);
    // A rail at the same instant, or rounding, may have turned the approach round.
    Real change =
        approach + std::max(e_ball_ * approach, least_opening(contact, e_ball_ * approach));
    if (change <= 0) return;
    const Real total = a.mass + b.mass;
    ImpactBall after_a{velocity(a), a.w, a.radius, a.mass};
    ImpactBall after_b{velocity(b), b.w, b.radius, b.mass};
    if (cloth_rubs_ && approach > 0 && vertical_part(a, b) == VerticalPart::kToSlate) {
        const Real mu = friction_.coefficient(norm(slip_velocity(n, after_a, after_b)));
        collide_mathavan2014({change / approach - 1, mu, mu_table_}, n, after_a, after_b);
        change = 0;
    } else if (has_friction_) {
        const Real impulse = change * (a.mass * b.mass / total);
        apply_tangential(friction_impulse(friction_, impulse, n, after_a, after_b), n,
                         vertical_part(a, b), after_a, after_b);
    }
    set_velocity(a, after_a.v - (change * (b.mass / total)) * n);
    set_velocity(b, after_b.v + (change * (a.mass / total)) * n);
    a.w = after_a.w;
    b.w = after_b.w;
}

Real ContactSolver::least_opening(const Contact& contact, Real opening_speed) {
    if (min_separation_ == 0) return 0;
    return slow_impacts_[contact.a * changes_.size() + contact.b].least_speed(opening_speed,
                                                                              min_separation_);
}

bool ContactSolver::resolve_group(std::span<MovingBall> balls) {
    // Those that do not approach take part only from the round on in which others make them.
    for (int round = 0; round < kMaxRounds; ++round) {
        approaching_.clear();
        for (const Contact& contact : group_) {
            Real speed = norm(balls[contact.a].v);
            if (contact.kind == Contact::Kind::kBalls) speed += norm(balls[contact.b].v);
            if (round == 0 || opening(contact, normal_of(contact, balls), balls) < -kStill * speed)
                approaching_.push_back(contact);
        }
        if (approaching_.empty()) {
            if (min_separation_ > 0) part_pressed(balls);
            return true;
        }
        reflect_together(balls);
    }
    return false;
}

/// How fast contact i opens for a unit of impulse at contact j, both impulses per unit mass.
Real ContactSolver::coupling(std::size_t i, std::size_t j,
                             std::span<const MovingBall> balls) const {
    const Contact& c = approaching_[i];
    const Contact& d = approaching_[j];
    Real shared = -direction_on(d, c.a) * (unit_mass_ / balls[c.a].mass);
    if (c.kind == Contact::Kind::kBalls)
        shared += direction_on(d, c.b) * (unit_mass_ / balls[c.b].mass);
    return shared * dot(normals_[i], normals_[j]);
}

/// The problem whose solution lets no contact approach.
void ContactSolver::pose(std::span<const MovingBall> balls) {
    const std::size_t n = approaching_.size();
    normals_.clear();
    for (const Contact& contact : approaching_)
        normals_.push_back(normal_of(contact, balls));
    problem_.reset(n);
    for (std::size_t i = 0; i < n; ++i) {
        problem_.q(i) = {opening(approaching_[i], normals_[i], balls)};
        for (std::size_t j = 0; j < n; ++j)
            problem_.g(i, j) = {coupling(i, j, balls)};
    }
}

/// One round of generalized reflections over the contacts that approach. Impulses and their sums
/// are taken in double-double and rounded once, so that the order of the contacts leaves no trace
/// in the velocities.
void ContactSolver::reflect_together(std::span<MovingBall> balls) {
    pose(balls);
    Real fastest = 0;
    for (std::size_t i = 0; i < problem_.size(); ++i)
        fastest = std::max(fastest, abs(problem_.q(i).hi));
    problem_.solve();
    for (std::size_t i = 0; i < problem_.size(); ++i)
        add_impulse(i, reflected_impulse(i), balls);
    if (has_friction_) rub_together(balls);
    apply_changes(kRounding * fastest, balls);
}

/// The impulse at contact i with its restitution, per unit mass.
DoubleDouble ContactSolver::reflected_impulse(std::size_t i) const {
    return DoubleDouble{1 + restitution(approaching_[i])} * problem_.x(i);
}

/// Balls that come together slowly again and again, pressed by the cloth, are made to part.
void ContactSolver::part_pressed(std::span<MovingBall> balls) {
    approaching_.clear();
    least_openings_.clear();
    bool any = false;
    for (const Contact& contact : group_) {
        if (contact.kind != Contact::Kind::kBalls) continue;
        const Real speed = opening(contact, normal_of(contact, balls), balls);
        approaching_.push_back(contact);
        least_openings_.push_back(least_opening(contact, speed));
        any = any || speed < least_openings_.back();
    }
    if (!any) return;
    pose(balls);
    for (std::size_t i = 0; i < problem_.size(); ++i)
        problem_.q(i) = problem_.q(i) - DoubleDouble{least_openings_[i]};
    problem_.solve();
    for (std::size_t i = 0; i < problem_.size(); ++i)
        add_impulse(i, problem_.x(i), balls);
    apply_changes(0, balls);
}

void ContactSolver::add_impulse(std::size_t contact, DoubleDouble size,
                                std::span<const MovingBall> balls) {
    const auto& [kind, a, b, rail, normal] = approaching_[contact];
    add(changes_[a].v, DoubleDouble{-(unit_mass_ / balls[a].mass)} * size, normals_[contact]);
    if (kind == Contact::Kind::kBalls)
        add(changes_[b].v, DoubleDouble{unit_mass_ / balls[b].mass} * size, normals_[contact]);
}

/// Friction of all contacts, by the slip that is left when all have bounced. By the slip of before,
/// it could drive what the other bounces have turned round; all at once, for there is no order.
void ContactSolver::rub_together(std::span<const MovingBall> balls) {
    pushes_.clear();
    for (std::size_t i = 0; i < problem_.size(); ++i)
        pushes_.push_back(friction_at(i, balls));
    for (std::size_t i = 0; i < problem_.size(); ++i)
        add_push(approaching_[i], pushes_[i], normals_[i], balls);
}

/// The impulse of friction on ball b of the contact (kg m/s), with the share of it that counts.
Vec3 ContactSolver::friction_at(std::size_t i, std::span<const MovingBall> balls) const {
    const Contact& contact = approaching_[i];
    const Real impulse = unit_mass_ * value(reflected_impulse(i));
    if (contact.kind != Contact::Kind::kBalls || impulse <= 0) return {};
    const auto ball_of = [&](std::size_t ball) {
        const MovingBall& before = balls[ball];
        return ImpactBall{velocity(before) + value(changes_[ball].v), before.w, before.radius,
                          before.mass};
    };
    // Each friction ends its own slip at most; a ball that has several would overshoot. So shared,
    // they cannot add energy: it is convex in the velocities.
    return 1 / static_cast<Real>(most_impacts_of(contact)) *
           friction_impulse(friction_, impulse, normals_[i], ball_of(contact.a),
                            ball_of(contact.b));
}

void ContactSolver::add_push(const Contact& contact, const Vec3& push, const Vec3& n,
                             std::span<const MovingBall> balls) {
    if (push == Vec3{}) return;
    const Vec3 torque = 2.5 * cross(push, n);
    Vec3 along = push;
    if (vertical_part(balls[contact.a], balls[contact.b]) == VerticalPart::kToSlate) along.z = 0;
    for (const std::size_t i : {contact.a, contact.b}) {
        const MovingBall& ball = balls[i];
        const DoubleDouble sign{direction_on(contact, i)};
        add(changes_[i].v, sign * DoubleDouble{1 / ball.mass}, along);
        add(changes_[i].w, DoubleDouble{1 / (ball.mass * ball.radius)}, torque);
    }
}

/// In how many impacts with balls the busier of the contact's two balls takes part.
int ContactSolver::most_impacts_of(const Contact& contact) const {
    int of_a = 0;
    int of_b = 0;
    for (const Contact& other : approaching_) {
        if (other.kind != Contact::Kind::kBalls) continue;
        of_a += direction_on(other, contact.a) != 0 ? 1 : 0;
        of_b += direction_on(other, contact.b) != 0 ? 1 : 0;
    }
    return std::max(of_a, of_b);
}

void ContactSolver::apply_changes(Real rounding, std::span<MovingBall> balls) {
    for (const Contact& contact : approaching_) {
        for (const std::size_t i : {contact.a, contact.b}) {
            // A ball of several contacts is changed once; the second time nothing is left.
            Change& change = changes_[i];
            MovingBall& ball = balls[i];
            ball.v.x = changed(ball.v.x, change.v.x, rounding);
            ball.v.y = changed(ball.v.y, change.v.y, rounding);
            ball.climb = changed(ball.climb, change.v.z, rounding);
            ball.w.x = changed(ball.w.x, change.w.x, 0);
            ball.w.y = changed(ball.w.y, change.w.y, 0);
            ball.w.z = changed(ball.w.z, change.w.z, 0);
            change = {};
        }
    }
}

}  // namespace poolhall
