#include "shared/physics/contact.hpp"

#include "shared/math/double_double.hpp"
#include "shared/physics/effects/ball_ball.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace poolhall {

namespace {

/// A group settles in a few rounds; elastic ones at most in as many as there are orders of impacts.
constexpr int kMaxRounds = 1000;
/// Pivots smaller than this (of entries of size 2) mean that a contact is redundant; speeds within
/// this share of the group's are rounding.
constexpr double kSingular = 1e-12;
/// Share of the group's speed that double-double arithmetic leaves of zero, generously.
constexpr double kRounding = 0x1p-90;

Vec2 normal_of(const Contact& contact, const std::vector<MovingBall>& balls) {
    if (contact.kind == Contact::Kind::kRail) return outward_normal(contact.rail);
    return normalized(balls[contact.b].r - balls[contact.a].r);
}

/// Whether the contact moves ball `ball` along its normal (+1), against it (-1) or not at all.
double direction_on(const Contact& contact, std::size_t ball) {
    if (contact.a == ball) return -1;
    return contact.kind == Contact::Kind::kBalls && contact.b == ball ? 1 : 0;
}

/// Rate at which the gap of the contact opens, m/s.
double opening(const Contact& contact, Vec2 n, const std::vector<MovingBall>& balls) {
    const double a = dot(balls[contact.a].v, n);
    return contact.kind == Contact::Kind::kRail ? -a : dot(balls[contact.b].v, n) - a;
}

void reflect(const Contact& contact, double e, MovingBall& ball) {
    double& v = contact.rail == Rail::kEast || contact.rail == Rail::kWest ? ball.v.x : ball.v.y;
    v = -e * v;
}

using Row = std::vector<DoubleDouble>;

/// The linear complementarity problem of a group: 0 <= x, 0 <= G x + q, and at each contact one of
/// the two is 0.
struct GroupProblem {
    std::vector<Vec2> normals;
    std::vector<Row> g;
    Row q;
    double largest_q = 0;
};

GroupProblem problem_of(std::span<const Contact> contacts, const std::vector<MovingBall>& balls) {
    const std::size_t n = contacts.size();
    GroupProblem problem;
    for (const Contact& contact : contacts) {
        const Vec2 normal = normal_of(contact, balls);
        const double q = opening(contact, normal, balls);
        problem.normals.push_back(normal);
        problem.q.push_back({q});
        problem.largest_q = std::max(problem.largest_q, std::abs(q));
    }
    problem.g.assign(n, Row(n));
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            double shared = -direction_on(contacts[j], contacts[i].a);
            if (contacts[i].kind == Contact::Kind::kBalls)
                shared += direction_on(contacts[j], contacts[i].b);
            problem.g[i][j] = {shared * dot(problem.normals[i], problem.normals[j])};
        }
    }
    return problem;
}

/// Solves the principal system G x = -q of the chosen contacts by elimination; redundant rows get
/// 0. G is positive semidefinite: its diagonal serves as pivots.
Row solve_chosen(const GroupProblem& problem, const std::vector<std::size_t>& chosen) {
    const std::size_t n = chosen.size();
    std::vector<Row> rows(n, Row(n + 1));
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j)
            rows[i][j] = problem.g[chosen[i]][chosen[j]];
        rows[i][n] = -problem.q[chosen[i]];
    }
    for (std::size_t i = 0; i < n; ++i) {
        if (rows[i][i].hi < kSingular) continue;
        for (std::size_t k = 0; k < n; ++k) {
            if (k == i) continue;
            const DoubleDouble factor = rows[k][i] / rows[i][i];
            for (std::size_t j = i; j <= n; ++j)
                rows[k][j] = rows[k][j] - factor * rows[i][j];
        }
    }
    Row x(n);
    for (std::size_t i = 0; i < n; ++i) {
        if (rows[i][i].hi >= kSingular) x[i] = rows[i][n] / rows[i][i];
    }
    return x;
}

/// Whether contact i breaks its condition: an impulse that pulls, or a gap that still closes.
bool violates(const GroupProblem& problem, const Row& x, std::size_t i, bool in_basis) {
    if (in_basis) return x[i].hi < 0;
    DoubleDouble rate = problem.q[i];
    for (std::size_t j = 0; j < x.size(); ++j)
        rate = rate + problem.g[i][j] * x[j];
    return rate.hi < -kSingular * problem.largest_q;
}

/// The impulses, by Murty's least-index pivoting.
Row solve(const GroupProblem& problem) {
    const std::size_t n = problem.q.size();
    std::vector<bool> in_basis(n, true);
    Row x(n);
    for (int round = 0; round < kMaxRounds; ++round) {
        std::vector<std::size_t> chosen;
        for (std::size_t i = 0; i < n; ++i) {
            if (in_basis[i]) chosen.push_back(i);
        }
        const Row part = solve_chosen(problem, chosen);
        std::fill(x.begin(), x.end(), DoubleDouble{});
        for (std::size_t i = 0; i < chosen.size(); ++i)
            x[chosen[i]] = part[i];
        std::size_t wrong = 0;
        while (wrong < n && !violates(problem, x, wrong, in_basis[wrong]))
            ++wrong;
        if (wrong == n) break;
        in_basis[wrong] = !in_basis[wrong];
    }
    return x;
}

void add(Vec2DoubleDouble& sum, DoubleDouble factor, Vec2 v) {
    sum.x = sum.x + factor * DoubleDouble{v.x};
    sum.y = sum.y + factor * DoubleDouble{v.y};
}

/// The double nearest to v + change; nothing where all but rounding of the double-doubles cancels.
double changed(double v, DoubleDouble change, double rounding) {
    const double sum = value(DoubleDouble{v} + change);
    return std::abs(sum) <= rounding ? 0 : sum;
}

/// One round of generalized reflections over the given contacts, all of which approach. Impulses
/// and their sums are taken in double-double and rounded once, so that the order of the contacts
/// leaves no trace in the velocities.
void reflect_together(std::span<const Contact> contacts, double e_rail,
                      std::vector<MovingBall>& balls) {
    const GroupProblem problem = problem_of(contacts, balls);
    const double rounding = kRounding * problem.largest_q;
    const Row impulse = solve(problem);
    std::vector<Vec2DoubleDouble> change(balls.size());
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const bool rail = contacts[i].kind == Contact::Kind::kRail;
        const DoubleDouble size = DoubleDouble{1 + (rail ? e_rail : 1)} * impulse[i];
        add(change[contacts[i].a], -size, problem.normals[i]);
        if (!rail) add(change[contacts[i].b], size, problem.normals[i]);
    }
    for (std::size_t i = 0; i < balls.size(); ++i) {
        balls[i].v.x = changed(balls[i].v.x, change[i].x, rounding);
        balls[i].v.y = changed(balls[i].v.y, change[i].y, rounding);
    }
}

bool still_closes(const Contact& contact, const std::vector<MovingBall>& balls) {
    double speed = norm(balls[contact.a].v);
    if (contact.kind == Contact::Kind::kBalls) speed += norm(balls[contact.b].v);
    return opening(contact, normal_of(contact, balls), balls) < -kSingular * speed;
}

bool share_a_ball(const Contact& c, const Contact& d) {
    return direction_on(d, c.a) != 0 ||
           (c.kind == Contact::Kind::kBalls && direction_on(d, c.b) != 0);
}

/// Contacts that share no ball with a ball-ball contact can go one by one, exactly.
bool independent(std::span<const Contact> contacts) {
    for (const Contact& c : contacts) {
        if (c.kind != Contact::Kind::kBalls) continue;
        for (const Contact& d : contacts) {
            if (&c != &d && share_a_ball(c, d)) return false;
        }
    }
    return true;
}

}  // namespace

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

bool resolve(std::span<const Contact> contacts, double e_rail, std::vector<MovingBall>& balls) {
    if (independent(contacts)) {
        for (const Contact& contact : contacts) {
            if (contact.kind == Contact::Kind::kRail) {
                reflect(contact, e_rail, balls[contact.a]);
            } else {
                exchange_normal_velocity(balls[contact.a].v, balls[contact.b].v,
                                         normal_of(contact, balls));
            }
        }
        return true;
    }
    std::vector<Contact> approaching(contacts.begin(), contacts.end());
    for (int round = 0; round < kMaxRounds; ++round) {
        if (approaching.empty()) return true;
        reflect_together(approaching, e_rail, balls);
        approaching.clear();
        std::copy_if(contacts.begin(), contacts.end(), std::back_inserter(approaching),
                     [&](const Contact& contact) { return still_closes(contact, balls); });
    }
    return false;
}

}  // namespace poolhall
