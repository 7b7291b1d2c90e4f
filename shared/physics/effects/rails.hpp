#pragma once

#include "shared/physics/scene.hpp"

#include <cmath>
#include <limits>
#include <optional>

namespace poolhall {

struct RailHit {
    double t = 0;  ///< s from now
    Rail rail = Rail::kNorth;
};

/// The rails as straight lines at which the normal velocity turns round: v_n' = -e v_n, the
/// tangential one stays. e = 1 is the original game (text, 5.2.2).
class Rails {
  public:
    explicit Rails(const Scene& scene)
        : inset_(called_for(scene) ? inset(scene.table, scene.ball.radius) : Vec2{kNever, kNever}),
          e_(scene.effects.rail.model == RailModel::kElastic ? 1 : scene.effects.rail.e) {}

    [[nodiscard]] static bool called_for(const Scene& scene) { return scene.table.rails; }

    /// When a ball at x with velocity v reaches +-edge; nothing if it does not move towards one. 0
    /// if it is there already.
    [[nodiscard]] static std::optional<double> time_to(double x, double v, double edge) {
        if (v == 0) return std::nullopt;
        const double way = v > 0 ? edge - x : edge + x;
        return way <= 0 ? 0 : way / (v > 0 ? v : -v);
    }

    /// False where the ball is far from reaching any rail within `time` s: most of them, most of
    /// the time, so it costs no division. Wider than any rounding.
    [[nodiscard]] bool may_reach(Vec2 r, Vec2 v, double time) const {
        constexpr double kGenerous = 1 + 0x1p-30;
        return kGenerous * (std::abs(r.x) + std::abs(v.x) * time) >= inset_.x ||
               kGenerous * (std::abs(r.y) + std::abs(v.y) * time) >= inset_.y;
    }

    /// When the ball reaches a short rail (x) or a long rail (y).
    [[nodiscard]] std::optional<RailHit> next_short_rail(Vec2 r, Vec2 v) const {
        const std::optional<double> t = time_to(r.x, v.x, inset_.x);
        if (!t) return std::nullopt;
        return RailHit{*t, v.x > 0 ? Rail::kEast : Rail::kWest};
    }

    [[nodiscard]] std::optional<RailHit> next_long_rail(Vec2 r, Vec2 v) const {
        const std::optional<double> t = time_to(r.y, v.y, inset_.y);
        if (!t) return std::nullopt;
        return RailHit{*t, v.y > 0 ? Rail::kNorth : Rail::kSouth};
    }

    /// |x| and |y| of a ball that touches the rails, m.
    [[nodiscard]] Vec2 edge() const { return inset_; }

    [[nodiscard]] double restitution() const { return e_; }

  private:
    static constexpr double kNever = std::numeric_limits<double>::infinity();

    Vec2 inset_;
    double e_;
};

}  // namespace poolhall
