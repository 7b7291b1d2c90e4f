#pragma once

#include "shared/physics/contact/time_of_impact.hpp"
#include "shared/physics/effects/scene_like.hpp"
#include "shared/physics/motion/moving_ball.hpp"
#include "shared/physics/search/circle_captures.hpp"
#include "shared/physics/search/table_hooks.hpp"
#include "shared/table/pockets.hpp"
#include "shared/table/pool_table.hpp"

#include <algorithm>
#include <optional>
#include <span>

namespace poolhall {

/// The rails of a full pool table, with its mouths, jaws and holes (pool_table.hpp).
class PoolMouths {
  public:
    explicit PoolMouths(const SceneLike auto& scene)
        : table_(called_for(scene) ? scene.table : Table{}),
          nose_{scene.table.length / 2, scene.table.width / 2},
          active_(called_for(scene)) {}

    [[nodiscard]] static bool called_for(const SceneLike auto& scene) {
        return scene.table.rails && scene.table.pockets == PocketModel::kPool;
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
            const Real gap = dot(line.from - ball.r, line.normal) - ball.reach;
            if (closing <= rounding || !faces(gap)) continue;
            const Real t = gap <= 0 ? 0 : gap / closing;
            if ((!first || t < first->t) && within(line, ball.r + t * v))
                first = CushionHit{t, line.rail, line.normal};
        }
        for (const CushionArc& arc : table_.arcs()) {
            const auto t = time_of_impact({ball.r, v}, {arc.centre, {}}, ball.reach + arc.radius);
            if (!t || (first && *t >= first->t)) continue;
            const Vec2 out = ball.r + *t * v - arc.centre;
            const Vec2 normal = -normalized(out);
            if (within(arc, out) && (*t > 0 || dot(v, normal) > rounding))
                first = CushionHit{*t, arc.rail, normal};
        }
        return first;
    }

  private:
    /// Holes come into the table a little, and places round.
    [[nodiscard]] Vec2 free_area() const {
        constexpr Real kGenerous = 1e-3;  // m
        const Real depth = table_.hole_depth() + kGenerous;
        return {nose_.x - depth, nose_.y - depth};
    }

    PoolTable table_;
    Vec2 nose_;
    bool active_;
};

}  // namespace poolhall
