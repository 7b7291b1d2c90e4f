#pragma once

#include "shared/math/vec2.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace poolhall {

/// Boxes around what balls cover in a stretch of time; only balls whose boxes overlap can meet.
/// Wider than any rounding.
class SweptBoxes {
  public:
    void resize(std::size_t balls) {
        x_.resize(balls);
        y_.resize(balls);
        half_x_.resize(balls);
        half_y_.resize(balls);
        moves_.resize(balls);
    }

    /// A ball that goes from r (m) by `way` (m).
    void set(std::size_t ball, Vec2 r, Vec2 way, double radius) {
        constexpr double kGenerous = 1 + 0x1p-30;
        x_[ball] = r.x + way.x / 2;
        y_[ball] = r.y + way.y / 2;
        half_x_[ball] = kGenerous * (radius + std::abs(way.x) / 2);
        half_y_[ball] = kGenerous * (radius + std::abs(way.y) / 2);
        moves_[ball] = way == Vec2{} ? 0 : 1;
    }

    /// A ball that meets nobody.
    void remove(std::size_t ball) {
        x_[ball] = y_[ball] = 0;
        half_x_[ball] = half_y_[ball] = -std::numeric_limits<double>::infinity();
        moves_[ball] = 0;
    }

    [[nodiscard]] bool overlap(std::size_t a, std::size_t b) const {
        // No short cut: the comparisons cost less than a branch that cannot be foreseen.
        const bool in_x = std::abs(x_[a] - x_[b]) <= half_x_[a] + half_x_[b];
        const bool in_y = std::abs(y_[a] - y_[b]) <= half_y_[a] + half_y_[b];
        return static_cast<int>(in_x) + static_cast<int>(in_y) == 2;
    }

    /// Calls meet(a, b), a < b, in order, for pairs of which one moves and whose boxes overlap.
    template <class Meet>
    void for_each_pair(Meet meet) const {
        for (std::size_t a = 0; a < x_.size(); ++a) {
            for (std::size_t b = a + 1; b < x_.size(); ++b) {
                if (overlap(a, b) && (moves_[a] | moves_[b]) != 0) meet(a, b);
            }
        }
    }

  private:
    // One array a quantity: the loop over pairs reads nothing else.
    std::vector<double> x_;
    std::vector<double> y_;
    std::vector<double> half_x_;
    std::vector<double> half_y_;
    std::vector<unsigned char> moves_;
};

}  // namespace poolhall
