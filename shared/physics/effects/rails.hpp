#pragma once

#include "shared/physics/effects/prospect.hpp"
#include "shared/physics/effects/scene_like.hpp"
#include "shared/physics/motion/event_kind.hpp"
#include "shared/physics/motion/moving_ball.hpp"
#include "shared/table/table.hpp"

#include <optional>
#include <string_view>

namespace poolhall {

struct RailHit {
    Real t = 0;  ///< s from now
    Rail rail = Rail::kNorth;
};

/// Where the four straight, unbroken rails are met. What happens there is in contact.hpp.
class Rails {
  public:
    static constexpr std::string_view kName = "rails";

    explicit Rails(const SceneLike auto& scene)
        : nose_(called_for(scene) ? Vec2{scene.table.length / 2, scene.table.width / 2}
                                  : Vec2{kInfinity, kInfinity}) {}

    [[nodiscard]] static bool called_for(const SceneLike auto& scene) {
        return scene.table.rails && scene.table.pockets != PocketModel::kPool;
    }

    [[nodiscard]] static std::optional<Bound> ruled_out(const SceneLike auto& /*scene*/,
                                                        const Prospect& prospect) {
        return Prospect::unless(prospect.rails, Bound::kOutOfReach);
    }

    [[nodiscard]] static constexpr bool acts_in(EventKind kind) {
        return kind == EventKind::kBallRail;
    }

    /// When a ball at x with velocity v reaches +-edge; nothing if it does not move towards one. 0
    /// if it is there already.
    [[nodiscard]] static std::optional<Real> time_to(Real x, Real v, Real edge) {
        if (v == 0) return std::nullopt;
        const Real way = v > 0 ? edge - x : edge + x;
        return way <= 0 ? 0 : way / (v > 0 ? v : -v);
    }

    /// False where the ball is far from reaching any rail within `time` s: most of them, most of
    /// the time, so it costs no division. Wider than any rounding.
    [[nodiscard]] bool may_reach(const MovingBall& ball, Vec2 v, Real time) const {
        constexpr Real kGenerous = 1 + 0x1p-30;
        const Vec2 edge = this->edge(ball.reach);
        return kGenerous * (abs(ball.r.x) + abs(v.x) * time) >= edge.x ||
               kGenerous * (abs(ball.r.y) + abs(v.y) * time) >= edge.y;
    }

    /// Up to which |x| and |y| a centre meets no rail, m.
    [[nodiscard]] Vec2 clear_area(Real radius) const { return edge(radius); }

    /// When the ball reaches a short rail (x) or a long rail (y).
    [[nodiscard]] std::optional<RailHit> next_short_rail(const MovingBall& ball, Vec2 v) const {
        const std::optional<Real> t = time_to(ball.r.x, v.x, edge(ball.reach).x);
        if (!t) return std::nullopt;
        return RailHit{*t, v.x > 0 ? Rail::kEast : Rail::kWest};
    }

    [[nodiscard]] std::optional<RailHit> next_long_rail(const MovingBall& ball, Vec2 v) const {
        const std::optional<Real> t = time_to(ball.r.y, v.y, edge(ball.reach).y);
        if (!t) return std::nullopt;
        return RailHit{*t, v.y > 0 ? Rail::kNorth : Rail::kSouth};
    }

    [[nodiscard]] bool is_there() const { return nose_.x < kInfinity; }

    /// |x| and |y| of a ball of that reach that touches the rails, m.
    [[nodiscard]] Vec2 edge(Real reach) const { return {nose_.x - reach, nose_.y - reach}; }

  private:
    Vec2 nose_;  ///< |x| and |y| of the noses, m
};

}  // namespace poolhall
