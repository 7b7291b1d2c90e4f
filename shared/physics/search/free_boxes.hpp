#pragma once

#include "shared/physics/search/boxes.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace poolhall {

/// Boxes in which balls are alone: as long as the centre of a ball stays in its own, it meets no
/// other ball that stays in its own, and nothing of the table. So a step of such a ball costs four
/// comparisons, and only the others, the loose ones, are looked at closely.
class FreeBoxes {
  public:
    /// Forgets all boxes. `room` and `many` are for Boxes.
    void reset(std::size_t balls, const Box& room, std::size_t many) {
        home_.assign(balls, kNowhere);
        reach_.reset(balls, room, many);
    }

    /// True if r is in the ball's box.
    [[nodiscard]] bool holds(std::size_t ball, Vec2 r) const {
        const Box& home = home_[ball];
        return home.low_x <= r.x && r.x <= home.high_x && home.low_y <= r.y && r.y <= home.high_y;
    }

    /// True for a ball without a box.
    [[nodiscard]] bool is_loose(std::size_t ball) const {
        return home_[ball].low_x > home_[ball].high_x;
    }

    /// A ball that meets nobody any more.
    void remove(std::size_t ball) {
        home_[ball] = kNowhere;
        reach_.remove(ball);
    }

    /// A ball at rest at r (m). Those in whose boxes it is become loose.
    void settle(std::size_t ball, Vec2 r, Real radius) {
        if (is_point(home_[ball]) && holds(ball, r)) return;
        home_[ball] = {r.x, r.x, r.y, r.y};
        reach_.set(ball, widened(home_[ball], radius));
        for_each_near(ball, [&](std::size_t other) {
            if (!is_point(home_[other])) home_[other] = kNowhere;
        });
    }

    /// A ball that may have been at rest and now moves.
    void wake(std::size_t ball) {
        if (is_point(home_[ball])) home_[ball] = kNowhere;
    }

    /// Makes the ball loose and notes what it covers when it goes straight from one place to
    /// another.
    void sweep(std::size_t ball, Vec2 from, Vec2 to, Real radius) {
        home_[ball] = kNowhere;
        const auto [low_x, high_x] = std::minmax(from.x, to.x);
        const auto [low_y, high_y] = std::minmax(from.y, to.y);
        reach_.set(ball, widened({low_x, high_x, low_y, high_y}, radius));
    }

    /// Gives the loose ball this box for its centre, if what it could cover there is clear of what
    /// others may.
    bool claim(std::size_t ball, const Box& centres, Real radius) {
        reach_.set(ball, widened(centres, radius));
        bool alone = true;
        for_each_near(ball, [&](std::size_t) { alone = false; });
        if (alone) home_[ball] = centres;
        return alone;
    }

    /// Calls meet(other) for every ball that may be where `ball` may be, in order.
    template <class Meet>
    void for_each_near(std::size_t ball, Meet meet) const {
        reach_.for_each_overlap(ball, 0, meet);
    }

  private:
    static constexpr Box kNowhere{kNever, -kNever, kNever, -kNever};

    static bool is_point(const Box& box) {
        return box.low_x == box.high_x && box.low_y == box.high_y;
    }

    /// By more than the radius: more than rounding.
    static Box widened(const Box& centres, Real radius) {
        const Real reach = (1 + 0x1p-20) * radius;
        return {centres.low_x - reach, centres.high_x + reach, centres.low_y - reach,
                centres.high_y + reach};
    }

    std::vector<Box> home_;  ///< of the centre; nowhere for a loose ball
    Boxes reach_;            ///< of the surface: in its box, or in this step if the ball is loose
};

}  // namespace poolhall
