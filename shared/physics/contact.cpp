#include "shared/physics/contact.hpp"

#include "shared/physics/effects/ball_ball.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace poolhall {

namespace {

/// A group settles in a few rounds; elastic ones at most in as many as there are orders of impacts.
constexpr int kMaxRounds = 1000;
/// Pivots smaller than this (of entries of size 2) mean that a contact is redundant.
constexpr double kSingular = 1e-12;

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

/// Solves the principal system G x = -q of the chosen contacts by elimination; redundant rows get
/// 0.
std::vector<double> solve_chosen(const std::vector<std::vector<double>>& g,
                                 const std::vector<double>& q,
                                 const std::vector<std::size_t>& chosen) {
    const std::size_t n = chosen.size();
    std::vector<std::vector<double>> rows(n, std::vector<double>(n + 1));
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j)
            rows[i][j] = g[chosen[i]][chosen[j]];
        rows[i][n] = -q[chosen[i]];
    }
    // G is positive semidefinite: its diagonal serves as pivots.
    for (std::size_t i = 0; i < n; ++i) {
        if (rows[i][i] < kSingular) continue;
        for (std::size_t k = 0; k < n; ++k) {
            if (k == i) continue;
            const double factor = rows[k][i] / rows[i][i];
            for (std::size_t j = i; j <= n; ++j)
                rows[k][j] -= factor * rows[i][j];
        }
    }
    std::vector<double> x(n);
    for (std::size_t i = 0; i < n; ++i)
        x[i] = rows[i][i] < kSingular ? 0 : rows[i][n] / rows[i][i];
    return x;
}

/// 0 <= x, 0 <= G x + q, complementary; by Murty's least-index pivoting, which ends for such G.
std::vector<double> solve_complementarity(const std::vector<std::vector<double>>& g,
                                          const std::vector<double>& q) {
    const std::size_t n = q.size();
    std::vector<bool> in_basis(n, true);
    std::vector<double> x(n);
    for (int round = 0; round < kMaxRounds; ++round) {
        std::vector<std::size_t> chosen;
        for (std::size_t i = 0; i < n; ++i) {
            if (in_basis[i]) chosen.push_back(i);
        }
        const std::vector<double> part = solve_chosen(g, q, chosen);
        std::fill(x.begin(), x.end(), 0.0);
        for (std::size_t i = 0; i < chosen.size(); ++i)
            x[chosen[i]] = part[i];
        const auto violates = [&](std::size_t i) {
            if (in_basis[i]) return x[i] < 0;
            return std::inner_product(x.begin(), x.end(), g[i].begin(), q[i]) <
                   -kSingular * std::abs(q[i]);
        };
        std::size_t wrong = 0;
        while (wrong < n && !violates(wrong))
            ++wrong;
        if (wrong == n) break;
        in_basis[wrong] = !in_basis[wrong];
    }
    return x;
}

/// One round of generalized reflections over the given contacts, all of which approach.
void reflect_together(std::span<const Contact> contacts, double e_rail,
                      std::vector<MovingBall>& balls) {
    const std::size_t n = contacts.size();
    std::vector<Vec2> normals(n);
    std::vector<double> q(n);
    for (std::size_t i = 0; i < n; ++i) {
        normals[i] = normal_of(contacts[i], balls);
        q[i] = opening(contacts[i], normals[i], balls);
    }
    std::vector<std::vector<double>> g(n, std::vector<double>(n));
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            double shared =
                direction_on(contacts[i], contacts[i].a) * direction_on(contacts[j], contacts[i].a);
            if (contacts[i].kind == Contact::Kind::kBalls)
                shared += direction_on(contacts[j], contacts[i].b);
            g[i][j] = shared * dot(normals[i], normals[j]);
        }
    }
    const std::vector<double> impulse = solve_complementarity(g, q);
    for (std::size_t i = 0; i < n; ++i) {
        const bool rail = contacts[i].kind == Contact::Kind::kRail;
        const Vec2 change = ((1 + (rail ? e_rail : 1)) * impulse[i]) * normals[i];
        balls[contacts[i].a].v = balls[contacts[i].a].v - change;
        if (!rail) balls[contacts[i].b].v = balls[contacts[i].b].v + change;
    }
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
    }
    return {};
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
                     [&](const Contact& contact) {
                         const double scale =
                             std::abs(balls[contact.a].v.x) + std::abs(balls[contact.a].v.y);
                         return opening(contact, normal_of(contact, balls), balls) <
                                -kSingular * scale;
                     });
    }
    return false;
}

}  // namespace poolhall
