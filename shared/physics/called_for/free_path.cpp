#include "shared/physics/called_for/free_path.hpp"

#include "shared/physics/motion/slip.hpp"

#include <algorithm>

namespace poolhall {

namespace {

/// Where a disc gets that goes from place to place.
class Hull {
  public:
    explicit Hull(Vec2 first) : low_(first), high_(first) {}

    void add(Vec2 place) {
        low_ = {std::min(low_.x, place.x), std::min(low_.y, place.y)};
        high_ = {std::max(high_.x, place.x), std::max(high_.y, place.y)};
    }

    [[nodiscard]] Box box(Real radius) const { return Box::around(low_, high_, radius); }

  private:
    Vec2 low_;   ///< m
    Vec2 high_;  ///< m
};

}  // namespace

ClothLaws::ClothLaws(const Scene& scene)
    : slip(Sliding(scene).slip_deceleration()),
      roll(Rolling(scene).roll_deceleration()),
      drag(LinearDrag(scene).drag_rate()),
      tick(scene.solver.kind == SolverKind::kEvent ? 0 : 1 / scene.solver.hz) {}

std::optional<Box> free_path(const MovingBall& ball, const ClothLaws& cloth) {
    Hull hull(ball.r);
    if (cloth.drag > 0) {
        if (cloth.slip > 0 || cloth.roll > 0) return std::nullopt;
        hull.add(ball.r + 1 / cloth.drag * ball.v);
        return hull.box(ball.radius);
    }
    if (cloth.roll == 0) return std::nullopt;
    Vec2 place = ball.r;
    Vec2 rolls = ball.v;
    Real speed = 0;
    if (cloth.slip > 0) {
        const Vec2 slip = slip_of(ball);
        speed = norm(slip);
        rolls = velocity_after_slip(ball.v, slip);
        const Real time = 2 * speed / (7 * cloth.slip);
        hull.add(place + time / 2 * ball.v);
        place = place + time * (rolls + Real{1} / 7 * slip);
        hull.add(place);
    }
    const Real rolling_speed = norm(rolls);
    speed += rolling_speed;
    hull.add(place + rolling_speed / (2 * cloth.roll) * rolls);
    return hull.box(ball.radius + 2 * cloth.tick * speed);
}

Real way_for_energy(const ClothLaws& cloth) {
    if (cloth.roll == 0 || cloth.drag > 0) return kInfinity;
    if (cloth.slip == 0) return 1 / cloth.roll;
    // V <= sqrt(E / 0.7), u <= sqrt(7 E): V u <= sqrt(10) E; generously, one after the other.
    constexpr Real kSlide = 2 * (1 + 3.1622776601683795) / 7;
    return 1 / (1.4 * cloth.roll) + kSlide / cloth.slip;
}

Real kinetic_energy(const MovingBall& ball) {
    return ball.mass *
           (dot(ball.v, ball.v) / 2 + ball.radius * ball.radius * dot(ball.w, ball.w) / 5);
}

}  // namespace poolhall
