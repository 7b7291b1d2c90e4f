#pragma once

#include "shared/physics/contact/time_of_impact.hpp"
#include "shared/physics/effects/prospect.hpp"
#include "shared/physics/effects/scene_like.hpp"
#include "shared/physics/motion/event_kind.hpp"
#include "shared/physics/motion/moving_ball.hpp"
#include "shared/physics/search/circle_captures.hpp"
#include "shared/physics/search/table_hooks.hpp"
#include "shared/table/pockets.hpp"
#include "shared/table/pool_table.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>

namespace poolhall {

/// The rails of a full pool table, with its mouths, jaws and holes (pool_table.hpp).
class PoolMouths {
  public:
    static constexpr std::string_view kName = "pool_mouths";

    explicit PoolMouths(const SceneLike auto& scene)
        : table_(called_for(scene) ? scene.table : Table{}),
          // The holes are at the mouths' middles, all on or beyond the long rails' noses.
          nose_{scene.table.length / 2, scene.table.width / 2},
          active_(called_for(scene)) {}

    [[nodiscard]] static bool called_for(const SceneLike auto& scene) {
        return scene.table.rails && scene.table.pockets == PocketModel::kPool;
    }

    /// Rubber is nowhere inside the noses. Neither are the side holes; those of the corners come in
    /// less far than their mouths are wide, so a ball that is out of them along either axis is
    /// safe.
    [[nodiscard]] static std::optional<Bound> ruled_out(const SceneLike auto& scene,
                                                        const Prospect& prospect) {
        static_assert(kSideMouth.shelf >= 0);
        const Vec2 clear{scene.table.length / 2 - kSideMouth.width,
                         scene.table.width / 2 - kSideMouth.width};
        const Box& reach = prospect.reach;
        const bool far = (reach.high_x < clear.x && reach.low_x > -clear.x) ||
                         (reach.high_y < clear.y && reach.low_y > -clear.y);
        return Prospect::unless(prospect.rails || !far, Bound::kOutOfReach);
    }

    [[nodiscard]] static constexpr bool acts_in(EventKind kind) {
        return kind == EventKind::kBallRail || kind == EventKind::kBallPocket;
    }

    [[nodiscard]] const PoolTable& table() const { return table_; }

    [[nodiscard]] std::span<const Hole> circles() const { return table_.holes(); }

    [[nodiscard]] Pocket pocket_of(std::size_t hole) const { return table_.holes()[hole].pocket; }

    /// False where a ball whose surface stays within the box touches nothing of rails and holes:
    /// most, most of the time.
    [[nodiscard]] bool may_reach(const Box& box) const {
        const Vec2 free = free_area();
        return active_ && (box.high_x >= free.x || box.low_x <= -free.x || box.high_y >= free.y ||
                           box.low_y <= -free.y);
    }

    /// Up to which |x| and |y| the centre of a ball touches nothing of rails and holes, m.
    [[nodiscard]] Vec2 clear_area(Real radius) const {
        const Vec2 free = active_ ? free_area() : Vec2{kNever, kNever};
        return {free.x - radius, free.y - radius};
    }

    [[nodiscard]] bool may_reach(const MovingBall& ball, Vec2 v, Real time) const {
        return may_reach(Box::around(ball.r, ball.r + time * v, ball.radius));
    }

    /// The first capture of a ball that moves from r with velocity v, within `time` s.
    [[nodiscard]] std::optional<Capture> first_capture(Vec2 r, Vec2 v, Real time) const {
        if (!active_) return std::nullopt;
        return first_capture_by(
            circles(), [this](std::size_t hole) { return pocket_of(hole); }, {r, v}, time);
    }

    /// The hole that holds a ball centred at r.
    [[nodiscard]] std::optional<Pocket> at(Vec2 r) const {
        for (const Hole& hole : table_.holes()) {
            if (active_ && is_in_circle(hole, r)) return hole.pocket;
        }
        return std::nullopt;
    }

    /// What a ball meets first if it moves on with velocity v; of a line and an arc at once the
    /// line, at whose end they have the same normal.
    [[nodiscard]] std::optional<CushionHit> straight_hit(const MovingBall& ball, Vec2 v) const {
        const Real rounding = rounding_of(v);
        std::optional<CushionHit> first;
        for (const CushionLine& line : table_.lines()) {
            const Real closing = dot(v, line.normal);
            const Real gap = dot(line.from - ball.r, line.normal) - ball.radius;
            if (closing <= rounding || !faces(gap)) continue;
            const Real t = gap <= 0 ? 0 : gap / closing;
            if ((!first || t < first->t) && within(line, ball.r + t * v))
                first = CushionHit{t, line.rail, line.normal};
        }
        for (const CushionArc& arc : table_.arcs()) {
            const auto t = time_of_impact({ball.r, v}, {arc.centre, {}}, ball.radius + arc.radius);
            if (!t || (first && *t >= first->t)) continue;
            const Vec2 out = ball.r + *t * v - arc.centre;
            const Vec2 normal = -normalized(out);
            if (within(arc, out) && (*t > 0 || dot(v, normal) > rounding))
                first = CushionHit{*t, arc.rail, normal};
        }
        return first;
    }

  private:
    /// Holes come into the table less far than their mouths are wide.
    [[nodiscard]] Vec2 free_area() const {
        return {nose_.x - kSideMouth.width, nose_.y - kSideMouth.width};
    }

    PoolTable table_;
    Vec2 nose_;
    bool active_;
};

}  // namespace poolhall
