#pragma once

#include "shared/math/complementarity.hpp"
#include "shared/physics/contact/ball_friction.hpp"
#include "shared/physics/contact/rail_spec.hpp"
#include "shared/physics/motion/moving_ball.hpp"
#include "shared/table/table.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace poolhall {

/// Two balls, or a ball and a rail, that touch and approach.
struct Contact {
    enum class Kind : std::uint8_t { kBalls, kRail };

    Kind kind = Kind::kBalls;
    std::size_t a = 0;
    std::size_t b = 0;         ///< kBalls; else a again
    Rail rail = Rail::kNorth;  ///< kRail
    Vec2 normal;               ///< kRail: unit, from the table into the rubber
};

/// A contact of ball a with one of the four straight rails.
[[nodiscard]] Contact rail_contact(std::size_t ball, Rail rail);
[[nodiscard]] Contact ball_contact(std::size_t a, std::size_t b);

/// The unit vector from the table into one of the four straight rails.
[[nodiscard]] Vec2 outward_normal(Rail rail);

/// Whether `contact`, one of `contacts`, shares no ball with a ball-ball contact (of which it may
/// be one itself).
[[nodiscard]] bool stands_alone(const Contact& contact, std::span<const Contact> contacts);

/// How often two bodies have met slowly in a row. Bodies that the cloth's friction presses together
/// meet again after each impact, ever sooner. The first slow impact is left as its model has it,
/// for nothing may bring the two together again; from the second on they part at a least speed that
/// quadruples each time: bounces too small to see, but few.
class SlowImpacts {
  public:
    /// The least speed of an impact that by itself would leave `speed`; both in m/s.
    [[nodiscard]] Real least_speed(Real speed, Real min_separation) {
        const Real least = count_ == 0 ? 0 : grown(min_separation, count_ - 1);
        if (speed > grown(min_separation, count_)) {
            count_ = 0;
        } else if (count_ < kMost) {
            ++count_;
        }
        return least;
    }

  private:
    static constexpr std::uint8_t kMost = 5;

    static constexpr Real grown(Real speed, int times) {
        return speed * static_cast<Real>(1 << (2 * times));
    }

    std::uint8_t count_ = 0;
};

/// What impacts depend on besides the balls.
struct ImpactModels {
    BallBallSpec ball_ball;
    RailSpec rail;
    Real mu_table = 0;      ///< friction of the cloth on a ball that slips, 0 if none
    Real unit_mass = 1;     ///< the mass of most balls, kg
    bool pressed = false;   ///< friction of the cloth can press two balls together
    bool in_space = false;  ///< balls may be at different heights
    std::size_t balls = 0;  ///< how many there are
};

/// Changes the velocities of balls whose contacts fall in the same instant, by the models that the
/// scene names.
///
/// Contacts that share no ball with a ball-ball contact go one by one. The others are one group:
/// generalized reflections (Smith, Kaufman, Vouga, Tamstorf, Grinspun, "Reflections on Simultaneous
/// Impact", SIGGRAPH 2012). Over the contacts that approach, the least impulses that stop them are
/// found together (a linear complementarity problem), then applied times 1 + e; again until none
/// approaches. Rails have infinite mass; Han's and Mathavan's rails are no impulse along a normal
/// and go first, ball by ball.
class ContactSolver {
  public:
    ContactSolver();

    /// Begins a shot with these models; keeps its memory.
    void prepare(const ImpactModels& models);

    /// False if it does not come to an end (never seen).
    [[nodiscard]] bool resolve(std::span<const Contact> contacts, std::span<MovingBall> balls);

    /// The unit vector from ball a to ball b, or from ball a into the rail.
    [[nodiscard]] Vec3 normal_of(const Contact& contact, std::span<const MovingBall> balls) const;

  private:
    [[nodiscard]] bool is_group_member(const Contact& contact) const;
    [[nodiscard]] Real restitution(const Contact& contact) const;
    void bounce(const Contact& contact, MovingBall& ball);
    void reflect(const Contact& contact, MovingBall& ball) const;
    void collide(const Contact& contact, std::span<MovingBall> balls);
    /// The least speed at which the balls of an impact part, m/s, if by themselves they would at
    /// `opening_speed`.
    [[nodiscard]] Real least_opening(const Contact& contact, Real opening_speed);
    [[nodiscard]] bool resolve_group(std::span<MovingBall> balls);
    void pose(std::span<const MovingBall> balls);
    [[nodiscard]] Real coupling(std::size_t i, std::size_t j,
                                std::span<const MovingBall> balls) const;
    void reflect_together(std::span<MovingBall> balls);
    [[nodiscard]] DoubleDouble reflected_impulse(std::size_t i) const;
    void part_pressed(std::span<MovingBall> balls);
    void add_impulse(std::size_t contact, DoubleDouble size, std::span<const MovingBall> balls);
    void rub_together(std::span<const MovingBall> balls);
    [[nodiscard]] Vec3 friction_at(std::size_t i, std::span<const MovingBall> balls) const;
    void add_push(const Contact& contact, const Vec3& push, const Vec3& n,
                  std::span<const MovingBall> balls);
    [[nodiscard]] int most_impacts_of(const Contact& contact) const;
    void apply_changes(Real rounding, std::span<MovingBall> balls);

    struct Change {
        Vec3DoubleDouble v;
        Vec3DoubleDouble w;
    };

    RailSpec rail_;
    Real e_ball_ = 1;
    Real e_rail_ = 1;
    Real mu_table_ = 0;
    Real unit_mass_ = 1;
    Real min_separation_ = 0;  ///< m/s; 0 where nothing presses balls together
    bool in_space_ = false;    ///< balls may be at different heights
    bool has_friction_ = false;
    bool cloth_rubs_ = false;  ///< while two balls touch
    BallFriction friction_{BallBallSpec{}};
    ComplementarityProblem problem_;
    std::vector<Contact> group_;        ///< contacts of the group
    std::vector<Contact> approaching_;  ///< those that approach, with normals_
    std::vector<Vec3> normals_;
    std::vector<Vec3> pushes_;               ///< of friction, kg m/s
    std::vector<Change> changes_;            ///< per ball
    std::vector<Real> least_openings_;       ///< m/s, per contact
    std::vector<SlowImpacts> slow_impacts_;  ///< per pair
    std::vector<SlowImpacts> slow_bounces_;  ///< per ball
};

}  // namespace poolhall
