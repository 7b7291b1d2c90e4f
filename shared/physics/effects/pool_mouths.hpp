#pragma once

#include "shared/physics/contact/time_of_impact.hpp"
#include "shared/physics/effects/prospect.hpp"
#include "shared/physics/effects/scene_like.hpp"
#include "shared/physics/motion/event_kind.hpp"
#include "shared/physics/motion/moving_ball.hpp"
#include "shared/physics/search/circle_captures.hpp"
#include "shared/physics/search/cushion_map.hpp"
#include "shared/physics/search/table_hooks.hpp"
#include "shared/table/pockets.hpp"
#include "shared/table/pool_table.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>

namespace poolhall {

/// The rails of a full pool table, with its mouths, jaws and holes (pool_table.hpp). Made from a
/// scene with `cushions`, a KeptCushionMap, which outlives it.
class PoolMouths {
  public:
    static constexpr std::string_view kName = "pool_mouths";

    explicit PoolMouths(const SceneLike auto& scene)
        : map_(called_for(scene) ? &scene.cushions.of(scene.table) : nullptr),
          free_(map_ != nullptr ? free_area(scene.table) : Vec2{kNever, kNever}) {}

    [[nodiscard]] static bool called_for(const SceneLike auto& scene) {
        return scene.table.rails && scene.table.pockets == PocketModel::kPool;
    }

    /// Rubber is nowhere inside the noses. Neither are the side holes; those of the corners come in
    /// a little, so a ball that is out of them along either axis is safe.
    [[nodiscard]] static std::optional<Bound> ruled_out(const SceneLike auto& scene,
                                                        const Prospect& prospect) {
        const Vec2 clear = free_area(scene.table);
        const Box& reach = prospect.reach;
        const bool far = (reach.high_x < clear.x && reach.low_x > -clear.x) ||
                         (reach.high_y < clear.y && reach.low_y > -clear.y);
        return Prospect::unless(prospect.rails || !far, Bound::kOutOfReach);
    }

    [[nodiscard]] static constexpr bool acts_in(EventKind kind) {
        return kind == EventKind::kBallRail || kind == EventKind::kBallPocket;
    }

    /// Where may_reach() of something.
    [[nodiscard]] const CushionMap& map() const { return *map_; }

    [[nodiscard]] std::span<const Hole> circles() const { return map_->table().holes(); }

    [[nodiscard]] Pocket pocket_of(std::size_t hole) const { return circles()[hole].pocket; }

    /// Calls visit(place) for the holes that a centre in the box may come into, in their order.
    template <class Visit>
    void for_each_circle_near(const Box& centres, Visit visit) const {
        map_->for_each_hole_near(centres, visit);
    }

    /// False where a ball whose surface stays within the box touches nothing of rails and holes:
    /// most, most of the time.
    [[nodiscard]] bool may_reach(const Box& box) const {
        return map_ != nullptr && (box.high_x >= free_.x || box.low_x <= -free_.x ||
                                   box.high_y >= free_.y || box.low_y <= -free_.y);
    }

    /// Up to which |x| and |y| the centre of a ball touches nothing of rails and holes, m.
    [[nodiscard]] Vec2 clear_area(Real radius) const {
        return {free_.x - radius, free_.y - radius};
    }

    [[nodiscard]] bool may_reach(const MovingBall& ball, Vec2 v, Real time) const {
        return may_reach(Box::around(ball.r, ball.r + time * v, ball.radius));
    }

    /// The first capture of a ball that moves from r with velocity v, within `time` s.
    [[nodiscard]] std::optional<Capture> first_capture(Vec2 r, Vec2 v, Real time) const {
        if (!may_reach(Box::around(r, r + time * v, 0))) return std::nullopt;
        return first_capture_by(
            circles(), [this](std::size_t hole) { return pocket_of(hole); }, {r, v}, time);
    }

    /// The hole that holds a ball centred at r.
    [[nodiscard]] std::optional<Pocket> at(Vec2 r) const {
        if (map_ == nullptr) return std::nullopt;
        for (const Hole& hole : circles()) {
            if (is_in_circle(hole, r)) return hole.pocket;
        }
        return std::nullopt;
    }

    /// What a ball meets first if it moves on with velocity v for `time` s; of a line and an arc at
    /// once the line, at whose end they have the same normal.
    [[nodiscard]] std::optional<CushionHit> straight_hit(const MovingBall& ball, Vec2 v,
                                                         Real time) const {
        const Box reach = Box::around(ball.r, ball.r + time * v, ball.radius);
        const Real rounding = rounding_of(v);
        std::optional<CushionHit> first;
        map_->for_each_line_near(reach, [&](const CushionLine& line) {
            const Real closing = dot(v, line.normal);
            const Real gap = dot(line.from - ball.r, line.normal) - ball.reach;
            if (closing <= rounding || !faces(gap)) return;
            const Real t = gap <= 0 ? 0 : gap / closing;
            if ((!first || t < first->t) && within(line, ball.r + t * v))
                first = CushionHit{t, line.rail, line.normal};
        });
        map_->for_each_arc_near(reach, [&](const CushionArc& arc) {
            const auto t = time_of_impact({ball.r, v}, {arc.centre, {}}, ball.reach + arc.radius);
            if (!t || (first && *t >= first->t)) return;
            const Vec2 out = ball.r + *t * v - arc.centre;
            const Vec2 normal = -normalized(out);
            if (within(arc, out) && (*t > 0 || dot(v, normal) > rounding))
                first = CushionHit{*t, arc.rail, normal};
        });
        return first;
    }

  private:
    /// Up to which |x| and |y| neither rubber nor holes are, m.
    [[nodiscard]] static Vec2 free_area(const Table& table) {
        constexpr Real kGenerous = 1e-3;  // m
        const Real depth = hole_depth(table) + kGenerous;
        return {table.length / 2 - depth, table.width / 2 - depth};
    }

    const CushionMap* map_;  ///< nothing where the scene has no such table
    Vec2 free_;              ///< free_area()
};

}  // namespace poolhall
