#pragma once

#include "shared/physics/effects/prospect.hpp"
#include "shared/physics/effects/scene_like.hpp"
#include "shared/physics/motion/event_kind.hpp"
#include "shared/physics/motion/moving_ball.hpp"
#include "shared/physics/search/box.hpp"
#include "shared/physics/search/circle_captures.hpp"
#include "shared/table/pockets.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>

namespace poolhall {

/// Pockets as circles in a table with unbroken rails: a ball is captured as soon as its centre
/// comes within the circle's radius of the circle's centre. The scene outlives the effect.
class PocketCircles {
  public:
    static constexpr std::string_view kName = "pocket_circles";

    explicit PocketCircles(const SceneLike auto& scene) : circles_(scene.table.circles) {
        if (!called_for(scene)) circles_ = {};
        for (const PocketCircle& circle : circles_)
            free_y_ = std::min(free_y_, abs(circle.centre.y) - circle.radius);
    }

    [[nodiscard]] static bool called_for(const SceneLike auto& scene) {
        return scene.table.pockets == PocketModel::kCircles && !scene.table.circles.empty();
    }

    [[nodiscard]] static std::optional<Bound> ruled_out(const SceneLike auto& scene,
                                                        const Prospect& prospect) {
        const auto near = [&](const PocketCircle& circle) {
            return !is_clear_of(prospect.reach, circle.centre, circle.radius);
        };
        return Prospect::unless(
            std::any_of(scene.table.circles.begin(), scene.table.circles.end(), near),
            Bound::kOutOfReach);
    }

    [[nodiscard]] static constexpr bool acts_in(EventKind kind) {
        return kind == EventKind::kBallPocket;
    }

    [[nodiscard]] std::span<const PocketCircle> circles() const { return circles_; }

    /// False where a ball whose centre stays within the box is far from all of them: most, most of
    /// the time, since pockets are usually at the long rails.
    [[nodiscard]] bool may_reach(const Box& box) const {
        return box.high_y >= free_y_ || box.low_y <= -free_y_;
    }

    /// Calls visit(place) for those that a centre in the box may come into, in their order.
    template <class Visit>
    void for_each_circle_near(const Box& centres, Visit visit) const {
        for (std::size_t i = 0; i < circles_.size(); ++i) {
            if (!is_clear_of(centres, circles_[i].centre, circles_[i].radius)) visit(i);
        }
    }

    /// Up to which |x| and |y| a centre meets none of them, m.
    [[nodiscard]] Vec2 clear_area(Real /*radius*/) const { return {kInfinity, free_y_}; }

    /// The first capture of a ball that moves from r with velocity v, within `time` s.
    [[nodiscard]] std::optional<Capture> first_capture(Vec2 r, Vec2 v, Real time) const {
        // Pockets are usually at the long rails, and most ticks pass far from them.
        constexpr Real kGenerous = 1 + 0x1p-30;
        if (kGenerous * (abs(r.y) + abs(v.y) * time) < free_y_) return std::nullopt;
        return first_capture_by(circles_, pocket_of, {r, v}, time);
    }

    /// The pocket that holds a ball centred at r.
    [[nodiscard]] std::optional<Pocket> at(Vec2 r) const {
        for (std::size_t i = 0; i < circles_.size(); ++i) {
            if (is_in_circle(circles_[i], r)) return pocket_of(i);
        }
        return std::nullopt;
    }

    [[nodiscard]] static Pocket pocket_of(std::size_t circle) {
        return static_cast<Pocket>(circle);
    }

  private:
    std::span<const PocketCircle> circles_;
    Real free_y_ = kInfinity;  ///< no circle nearer to y = 0 than this, m
};

}  // namespace poolhall
